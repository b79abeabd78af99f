#include "numerics/progress.h"

#include <algorithm>
#include <utility>

namespace flexslip {

Watch::Watch(std::function<void(const Reached&)> report)
    : report_(std::move(report)), before_(effort_spent.watch_), begun_(effort_spent.spent_), entered_(begun_) {
  effort_spent.set_watch(this);
}

Watch::~Watch() { effort_spent.set_watch(before_); }

void Watch::begin(const Stretch& next) {
  now_ = next;
  entered_ = effort_spent.spent();
  notify();
}

void Watch::notify() { report_({now_.stage, share()}); }

double Watch::share() const {
  const double before = static_cast<double>(entered_ - begun_),
               since = static_cast<double>(effort_spent.spent() - entered_);
  if (!(before > 0 && now_.from > 0 && now_.to > now_.from)) return now_.from;
  const double expected = before / now_.from * (now_.to - now_.from), of_it = since / expected;
  const double done = of_it < 0.5 ? of_it : 1 - 0.25 / of_it;  // smooth at 0.5
  return std::min(now_.from + (now_.to - now_.from) * done, now_.to);
}

void Effort::set_watch(Watch* watch) {
  watch_ = watch;
  next_report_ = watch ? spent_ + Watch::every : never;
}

void Effort::notify() {
  next_report_ = spent_ + Watch::every;
  watch_->notify();
}

Stages::Stages() : watch_(effort_spent.watch_) {
  if (watch_) whole_ = {watch_->now_.stage, watch_->share(), watch_->now_.to};
}

Stages::~Stages() {
  if (watch_) watch_->now_ = {whole_.stage, whole_.to, whole_.to};
}

void Stages::enter(std::string_view name, double share) {
  if (!watch_) return;
  done_ += next_;
  next_ = share;
  const auto at = [&](double part) { return std::min(whole_.from + (whole_.to - whole_.from) * part, whole_.to); };
  watch_->begin({name.empty() ? whole_.stage : name, at(done_), at(done_ + next_)});
}

}  // namespace flexslip
