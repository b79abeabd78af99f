// nlopt_optimize with the one algorithm that the program asks for (numerics/minimum.cpp): NLopt's own would bring all of its algorithms into the page.
#include <neldermead.h>
#include <nlopt-internal.h>

nlopt_result nlopt_optimize(nlopt_opt opt, double* x, double* least) {
  if (opt->algorithm != NLOPT_LN_NELDERMEAD || opt->maximize || opt->dx == NULL) return NLOPT_INVALID_ARGS;
  opt->numevals = 0;
  nlopt_stopping stop = {.n = opt->n,
                         .minf_max = opt->stopval,
                         .ftol_rel = opt->ftol_rel,
                         .ftol_abs = opt->ftol_abs,
                         .xtol_rel = opt->xtol_rel,
                         .xtol_abs = opt->xtol_abs,
                         .x_weights = opt->x_weights,
                         .nevals_p = &opt->numevals,
                         .maxeval = opt->maxeval,
                         .maxtime = opt->maxtime,
                         .start = nlopt_seconds(),
                         .force_stop = &opt->force_stop,
                         .stop_msg = &opt->errmsg};
  *least = HUGE_VAL;
  return nldrmd_minimize((int)opt->n, opt->f, opt->f_data, opt->lb, opt->ub, x, least, opt->dx, &stop);
}
