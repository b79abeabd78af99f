"""The answers and their types: written by tools/write-python-stubs."""
from typing import Any

import numpy as np
import numpy.typing as npt

from ._answers import Answer, Estimate, Quantity, Table

Numbers = npt.NDArray[np.float64]
Objects = npt.NDArray[np.object_]


class FitUnits(Answer):
    """of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class FitForceOverFrictionless(Answer):
    """the force over that without friction, past a tenth of the span; below 1, no friction explains it"""

    @property
    def median(self) -> float:
        """over the points [1]"""
    @property
    def least(self) -> float:
        """of them [1]"""

class FitParametersMu0(Estimate):
    """mean friction over the fibre seen"""

    @property
    def bound(self) -> bool:
        """the record does not tell it from 0: the upper end of its interval is a limit"""

class FitParameters(Answer):
    """what was fitted; those of the model that the fit is of"""

    @property
    def mu0(self) -> FitParametersMu0 | None:
        """mean friction over the fibre seen [1]"""
    @property
    def amplitude(self) -> Estimate | None:
        """of the likeliest wave of friction, relative to mu0 [1]"""
    @property
    def wavelength(self) -> Estimate | None:
        """of that wave, along the specimen [m]"""
    @property
    def phase(self) -> Estimate | None:
        """of that wave, at the length 0 [rad]"""
    @property
    def phase_at_middle(self) -> Estimate | None:
        """of that wave, at the reference [rad]"""
    @property
    def amplitude_2(self) -> Estimate | None:
        """of the second wave, relative to mu0 [1]"""
    @property
    def wavelength_2(self) -> Estimate | None:
        """of the second wave, along the specimen [m]"""
    @property
    def phase_2(self) -> Estimate | None:
        """of the second wave, at the length 0 [rad]"""
    @property
    def phase_at_middle_2(self) -> Estimate | None:
        """of the second wave, at the reference [rad]"""
    @property
    def drift(self) -> Estimate | None:
        """slope of friction along the specimen [1/m]"""
    @property
    def force_noise(self) -> Estimate | None:
        """standard deviation of a force reading, by the fit [N]"""
    @property
    def roughness(self) -> Estimate | None:
        """standard deviation of friction about its mean [1]"""
    @property
    def correlation_length(self) -> Estimate | None:
        """of the roughness along the specimen [m]"""
    @property
    def bending_stiffness(self) -> Estimate | None:
        """EI of the fit [N m^2]"""
    @property
    def reference(self) -> Estimate | None:
        """length between the contacts where phase_at_middle, and mu0 with drift and wave, hold [m]"""
    @property
    def contact_offset(self) -> Estimate:
        """stage position of the contact in the file, taken off [m]"""

class FitFrictionRead(Answer):
    """friction read off the curve point by point, at the bending stiffness of the fit: quantiles of mu in profile"""

    @property
    def median(self) -> float:
        """half of the points lie below it [1]"""
    @property
    def low80(self) -> float:
        """a tenth of the points lie below it [1]"""
    @property
    def high80(self) -> float:
        """a tenth of the points lie above it [1]"""

class FitChecks(Answer):
    """what the fit is held against; numbers of a check are those that it has"""

    @property
    def name(self) -> str:
        """residuals, drops, whiteness, nesting, friction, stability or stiffness"""
    @property
    def passed(self) -> bool | None:
        """null where it is not possible"""
    @property
    def remedy(self) -> str | None:
        """what to do where it failed"""
    @property
    def residual_rms(self) -> float:
        """by which the mean of the fit, run forward, misses the force [N]"""
    @property
    def greatest_force(self) -> float:
        """greatest force measured [N]"""
    @property
    def threshold(self) -> float:
        """smallest drop that is counted [N]"""
    @property
    def record(self) -> float:
        """drops of the record [1]"""
    @property
    def draws_low(self) -> float:
        """fewest drops of a profile drawn from the fit [1]"""
    @property
    def draws_median(self) -> float:
        """drops of such profiles, median [1]"""
    @property
    def draws_high(self) -> float:
        """most drops of such a profile [1]"""
    @property
    def record_fall(self) -> float:
        """mean fall in the drops of the record [N]"""
    @property
    def draws_fall(self) -> float:
        """mean fall in the drops of such profiles [N]"""
    @property
    def ljung_box(self) -> float:
        """Ljung and Box's statistic of what the fit leaves [1]"""
    @property
    def lags(self) -> float:
        """readings over which it is taken [1]"""
    @property
    def p_value(self) -> float:
        """probability of as much from noise alone [1]"""
    @property
    def most_below(self) -> float:
        """greatest ln L by which the explanation lies below one that it contains [1]"""
    @property
    def mu0_high(self) -> float:
        """upper end of the 95 % interval of mu0 [1]"""
    @property
    def mu0_moved(self) -> float:
        """standard errors that mu0 moves by as the force changes in its ninth digit [1]"""
    @property
    def same_explanation(self) -> float:
        """1 if the likeliest explanation stays then, else 0 [1]"""
    @property
    def fitted_over_nominal(self) -> float:
        """bending stiffness of the fit over the nominal one [1]"""
    @property
    def errors(self) -> float:
        """of the nominal one, by which they differ [1]"""

class FitChecksTable(Table[FitChecks]):
    name: Objects
    passed: Objects
    remedy: Objects
    residual_rms: Numbers
    greatest_force: Numbers
    threshold: Numbers
    record: Numbers
    draws_low: Numbers
    draws_median: Numbers
    draws_high: Numbers
    record_fall: Numbers
    draws_fall: Numbers
    ljung_box: Numbers
    lags: Numbers
    p_value: Numbers
    most_below: Numbers
    mu0_high: Numbers
    mu0_moved: Numbers
    same_explanation: Numbers
    fitted_over_nominal: Numbers
    errors: Numbers

class FitWave(Answer):
    """the likeliest wave, claimed or not; null without one"""

    @property
    def claimed(self) -> bool:
        """by the evidence, and shorter than a quarter of the fibre seen"""
    @property
    def log_evidence(self) -> float:
        """ln of the evidence with a wave over that without [1]"""
    @property
    def amplitude(self) -> Estimate:
        """of the likeliest wave of friction, relative to mu0 [1]"""
    @property
    def wavelength(self) -> Estimate:
        """of that wave, along the specimen [m]"""
    @property
    def phase(self) -> Estimate:
        """of that wave, at the length 0 [rad]"""
    @property
    def phase_at_middle(self) -> Estimate:
        """of that wave, at the reference [rad]"""

class FitOneSideAtATime(Answer):
    """lengths along the specimen if it slid over one support at a time"""

    @property
    def name(self) -> str:
        """of the parameter"""
    @property
    def value(self) -> float:
        """its value then [m]"""

class FitOneSideAtATimeTable(Table[FitOneSideAtATime]):
    name: Objects
    value: Numbers

class FitExplanations(Answer):
    """that the answer averages over, likeliest first"""

    @property
    def kernel(self) -> str:
        """of the roughness: exponential, matern_3_2, matern_5_2 or none"""
    @property
    def wavelengths(self) -> Numbers:
        """of its waves [m]"""
    @property
    def weight(self) -> float:
        """of all; they add up to 1 [1]"""
    @property
    def log_evidence(self) -> float:
        """ln of its evidence [1]"""
    @property
    def log_likelihood(self) -> float:
        """ln of its likelihood where its posterior is greatest [1]"""

class FitExplanationsTable(Table[FitExplanations]):
    kernel: Objects
    wavelengths: Objects
    weight: Numbers
    log_evidence: Numbers
    log_likelihood: Numbers

class FitSnaps(Answer):
    """of the mean of the fit, run forward"""

    @property
    def stage(self) -> float:
        """stage position, which does not change on the way [m]"""
    @property
    def deflection_before(self) -> float:
        """deflection before it [m]"""
    @property
    def deflection_after(self) -> float:
        """deflection after it [m]"""
    @property
    def force_before(self) -> float:
        """force before it [N]"""
    @property
    def force_after(self) -> float:
        """force after it [N]"""
    @property
    def length_before(self) -> float:
        """drawn in before it, and the span [m]"""
    @property
    def length_after(self) -> float:
        """drawn in after it, and the span [m]"""

class FitSnapsTable(Table[FitSnaps]):
    stage: Numbers
    deflection_before: Numbers
    deflection_after: Numbers
    force_before: Numbers
    force_after: Numbers
    length_before: Numbers
    length_after: Numbers

class FitJudgement(Answer):
    """what the test comes to when all is weighed"""

    @property
    def standing(self) -> str:
        """sound, doubtful, suspect or untrusted"""
    @property
    def drops(self) -> str | None:
        """not_by_cracks_alone, cracks or cannot_be_told, by the rises and by a reload; null without drops"""
    @property
    def doubts(self) -> tuple[str, ...]:
        """what stands against the answer, the weightiest first: wrong_stiffness, no_sliding, softer_reload, cracks, impossible_drops,
        implausible_friction, failed_check, falling_friction, changed_reload, coarse_force, undecided_drops, few_rows, below_frictionless,
        settling_contact, unexpected_stiffness"""
    @property
    def next_step(self) -> str:
        """what would tell most: none, check_case, reload, finer_steps, stiffer_rig, image_length, state_radius, find_contact, finer_force,
        measure_stiffness or see_checks"""
    @property
    def stiffness_lost(self) -> float:
        """share lost, that the last comparable reload shows [1]"""
    @property
    def stiffness_lost_error(self) -> float:
        """its standard error [1]"""
    @property
    def stiffness_loss_needed(self) -> float:
        """share that cracks alone would need to make the drops; null without a reload [1]"""
    @property
    def stiffness_for_no_snap(self) -> float:
        """of a rig on which the mean of the fit does not snap [N/m]"""

class FitSurfaceProfile(Answer):
    """along the specimen"""

    @property
    def position(self) -> Numbers:
        """from midspan [m]"""
    @property
    def slope(self) -> Numbers:
        """of the surface, by the mean of the fit [1]"""
    @property
    def slope_deviation(self) -> Numbers:
        """standard deviation of the draws [1]"""
    @property
    def height(self) -> Numbers:
        """by the mean of the fit, without tilt [m]"""
    @property
    def height_deviation(self) -> Numbers:
        """standard deviation of the draws [m]"""

class FitSurfaceAgainstTrace(Answer):
    """a height trace it was held against; null without one"""

    @property
    def file(self) -> str:
        """the trace, as it was given"""
    @property
    def step(self) -> float:
        """between its heights [m]"""
    @property
    def field(self) -> float:
        """its width [m]"""
    @property
    def pixel(self) -> float:
        """least difference of its heights; null if they are as fine as their noise [m]"""
    @property
    def rms_slope(self) -> Estimate | None:
        """of the trace, of waves between the next two [1]"""
    @property
    def shortest(self) -> float:
        """wavelength that it is told of [m]"""
    @property
    def longest(self) -> float:
        """likewise [m]"""
    @property
    def least_amplitude_by_spectrum(self) -> float:
        """of a coherent wave as long as that of friction, that would stand out of the trace; null without a wave [m]"""
    @property
    def least_amplitude_by_pixels(self) -> float:
        """by the paper's rule; null where the pixel is not known [m]"""
    @property
    def correlation(self) -> float:
        """of the slopes, where they fit best [1]"""
    @property
    def p_value(self) -> float:
        """that chance finds as high a correlation at any place, either way round [1]"""
    @property
    def places(self) -> int:
        """that were tried, both ways round"""
    @property
    def begin(self) -> float:
        """of the trace, where the support stood at first, at the best place [m]"""
    @property
    def turned(self) -> bool:
        """the trace is run through the other way there"""
    @property
    def overlap(self) -> float:
        """of trace and friction there [m]"""

class FitSurface(Answer):
    """that would explain how friction varies; null where it does not"""

    @property
    def base_friction(self) -> float:
        """of the flat surface: that for which the slopes are zero on average [1]"""
    @property
    def rms_slope(self) -> Estimate:
        """of the slopes that would show the friction, of waves up to longest [1]"""
    @property
    def rms_height(self) -> Estimate:
        """of the heights, likewise [m]"""
    @property
    def longest(self) -> float:
        """wavelength that these are told of, a quarter of the fibre seen [m]"""
    @property
    def wave_height(self) -> Estimate | None:
        """amplitude of the wave of height that would show the likeliest wave of friction; null without one [m]"""
    @property
    def wavelength(self) -> float:
        """of that wave [m]"""
    @property
    def wave_claimed(self) -> bool | None:
        """it is claimed by the evidence"""
    @property
    def pixel_wanted(self) -> float:
        """to see it by the paper's rule, ten pixels from crest to trough [m]"""
    @property
    def field_wanted(self) -> float:
        """by that rule, ten waves [m]"""
    @property
    def profile(self) -> FitSurfaceProfile:
        """along the specimen"""
    @property
    def against_trace(self) -> FitSurfaceAgainstTrace | None:
        """a height trace it was held against; null without one"""

class FitBending(Answer):
    """how far the specimen was strained"""

    @property
    def greatest_strain(self) -> float:
        """of the surface at midspan; null without a section [1]"""
    @property
    def greatest_stress(self) -> float:
        """of the surface at midspan, at the modulus fitted; null without a section [Pa]"""
    @property
    def wraps_nose(self) -> bool:
        """it was bent more sharply than the nose"""

class FitImagedLengthPoints(Answer):
    """that were imaged"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def pulled_in(self) -> float:
        """length drawn in, from the force [m]"""
    @property
    def imaged(self) -> float:
        """likewise, as imaged [m]"""

class FitImagedLengthPointsTable(Table[FitImagedLengthPoints]):
    row: Any
    pulled_in: Numbers
    imaged: Numbers

class FitImagedLength(Answer):
    """lengths that were imaged, against those read off the force; null without any"""

    @property
    def offset(self) -> float:
        """what the force says less what was imaged, median [m]"""
    @property
    def standard_error(self) -> float:
        """of offset, if the points erred independently [m]"""
    @property
    def scatter(self) -> float:
        """about it, 1.48 times the median absolute deviation [m]"""
    @property
    def points(self) -> FitImagedLengthPointsTable:
        """that were imaged"""

class FitSlipOrCrackCracks(Answer):
    """cracks that are arrested, friction free"""

    @property
    def bic(self) -> float:
        """Bayes' information criterion [1]"""
    @property
    def friction(self) -> float:
        """mean friction [1]"""
    @property
    def stiffness_left(self) -> float:
        """bending stiffness after the last drop over that before the first [1]"""

class FitSlipOrCrackCracksConstant(Answer):
    """likewise, friction constant"""

    @property
    def bic(self) -> float:
        """Bayes' information criterion [1]"""
    @property
    def friction(self) -> float:
        """mean friction [1]"""
    @property
    def stiffness_left(self) -> float:
        """bending stiffness after the last drop over that before the first [1]"""

class FitSlipOrCrackCracksRunning(Answer):
    """cracks that run on within a rise"""

    @property
    def bic(self) -> float:
        """Bayes' information criterion [1]"""
    @property
    def friction(self) -> float:
        """mean friction [1]"""
    @property
    def stiffness_left(self) -> float:
        """bending stiffness after the last drop over that before the first [1]"""

class FitSlipOrCrackSlip(Answer):
    """slips alone"""

    @property
    def bic(self) -> float:
        """Bayes' information criterion [1]"""
    @property
    def friction(self) -> float:
        """mean friction [1]"""
    @property
    def stiffness_left(self) -> float:
        """bending stiffness after the last drop over that before the first [1]"""

class FitSlipOrCrackSlipAndCracks(Answer):
    """both"""

    @property
    def bic(self) -> float:
        """Bayes' information criterion [1]"""
    @property
    def friction(self) -> float:
        """mean friction [1]"""
    @property
    def stiffness_left(self) -> float:
        """bending stiffness after the last drop over that before the first [1]"""

class FitSlipOrCrack(Answer):
    """what the rises between the drops say of them; null where these are too few"""

    @property
    def verdict(self) -> str:
        """not_by_cracks_alone, cracks or cannot_be_told"""
    @property
    def margin(self) -> float:
        """D*: BIC of the best of the cracks less that of the best of the slips [1]"""
    @property
    def margin_arrested(self) -> float:
        """D: likewise, without cracks that run on within a rise [1]"""
    @property
    def rises(self) -> int:
        """between the drops that are judged"""
    @property
    def stiffer_rises(self) -> int:
        """of these, those that grow stiffer towards their end"""
    @property
    def cracks(self) -> FitSlipOrCrackCracks:
        """cracks that are arrested, friction free"""
    @property
    def cracks_constant(self) -> FitSlipOrCrackCracksConstant:
        """likewise, friction constant"""
    @property
    def cracks_running(self) -> FitSlipOrCrackCracksRunning:
        """cracks that run on within a rise"""
    @property
    def slip(self) -> FitSlipOrCrackSlip:
        """slips alone"""
    @property
    def slip_and_cracks(self) -> FitSlipOrCrackSlipAndCracks:
        """both"""

class FitDrops(Answer):
    """of the force"""

    @property
    def row_before(self) -> int:
        """row of the file before the drop"""
    @property
    def row_after(self) -> int:
        """row of the file after it"""
    @property
    def stage(self) -> float:
        """stage position before it [m]"""
    @property
    def deflection_before(self) -> float:
        """deflection before it [m]"""
    @property
    def deflection_after(self) -> float:
        """deflection after it [m]"""
    @property
    def force_before(self) -> float:
        """force before it [N]"""
    @property
    def force_after(self) -> float:
        """force after it [N]"""
    @property
    def force_fall(self) -> float:
        """by which the force falls [N]"""
    @property
    def significance(self) -> float:
        """fall beyond that of the smooth curve, in standard deviations of the noise [1]"""
    @property
    def false_alarms(self) -> float:
        """drops as significant to be expected in a test of this length without slips [1]"""
    @property
    def slip(self) -> str:
        """whether it can be a slip: possible, too_short to judge, or why not: unexplained by any friction, implausible friction before, negative
        friction after, moves_out"""
    @property
    def pulled_in(self) -> Estimate:
        """length that it draws in over both supports, if it is a slip [m]"""
    @property
    def mu_before(self) -> float:
        """friction before it, if it is a slip [1]"""
    @property
    def mu_after(self) -> float:
        """friction after it, likewise [1]"""

class FitDropsTable(Table[FitDrops]):
    row_before: Any
    row_after: Any
    stage: Numbers
    deflection_before: Numbers
    deflection_after: Numbers
    force_before: Numbers
    force_after: Numbers
    force_fall: Numbers
    significance: Numbers
    false_alarms: Numbers
    slip: Objects
    pulled_in: Objects
    mu_before: Numbers
    mu_after: Numbers

class FitSlipsSlips(Answer):
    """those drops"""

    @property
    def row_before(self) -> int:
        """row of the file before the slip"""
    @property
    def row_after(self) -> int:
        """row of the file after it"""
    @property
    def length_before(self) -> float:
        """drawn in before it, and the span [m]"""
    @property
    def length_after(self) -> float:
        """drawn in after it, and the span [m]"""
    @property
    def mu_before(self) -> float:
        """friction before it [1]"""
    @property
    def mu_after(self) -> float:
        """friction after it [1]"""

class FitSlipsSlipsTable(Table[FitSlipsSlips]):
    row_before: Any
    row_after: Any
    length_before: Numbers
    length_after: Numbers
    mu_before: Numbers
    mu_after: Numbers

class FitSlips(Answer):
    """the drops that can be slips by the bending stiffness stated, read at that of the fit"""

    @property
    def count(self) -> int:
        """drops that slips can explain"""
    @property
    def median_spacing(self) -> float:
        """of the specimen that passes over a support from the beginning of a slip to that of the next, median [m]"""
    @property
    def mean_spacing(self) -> float:
        """likewise, mean [m]"""
    @property
    def median_fall_of_mu(self) -> float:
        """by which friction falls in a slip, median [1]"""
    @property
    def slips(self) -> FitSlipsSlipsTable:
        """those drops"""

class FitTeethCompliance(Answer):
    """of supports that give way"""

    @property
    def status(self) -> str:
        """ok, too_few_teeth or none_fits"""
    @property
    def value(self) -> float:
        """of both supports together, if the specimen were stuck [m/N]"""
    @property
    def standard_error(self) -> float:
        """of value, from scatter [m/N]"""
    @property
    def systematic(self) -> float:
        """error of value from EI, contact and load train [m/N]"""
    @property
    def unit(self) -> str | None:
        """of these"""
    @property
    def chi_squared(self) -> float:
        """of the slopes about it [1]"""
    @property
    def freedom(self) -> int | None:
        """degrees of freedom"""
    @property
    def p_value(self) -> float:
        """probability of so large a chi_squared of a specimen that is stuck [1]"""

class FitTeethTeeth(Answer):
    """the rises between drops"""

    @property
    def first_row(self) -> int:
        """first row of the file of the rise"""
    @property
    def last_row(self) -> int:
        """its last row"""
    @property
    def length_before(self) -> float:
        """drawn in where it begins, and the span [m]"""
    @property
    def length_after(self) -> float:
        """drawn in where it ends, and the span [m]"""
    @property
    def q_before(self) -> float:
        """mobilised friction where it begins [1]"""
    @property
    def q_after(self) -> float:
        """mobilised friction where it ends [1]"""
    @property
    def slope(self) -> Estimate:
        """force over stage position, mean of the rise [N/m]"""
    @property
    def stick_slope(self) -> float:
        """likewise, of a specimen that is stuck [N/m]"""
    @property
    def slide_slope(self) -> float:
        """likewise, of one that slides at constant friction [N/m]"""
    @property
    def position(self) -> Estimate:
        """p: 1 where the slope is that of sticking, 0 where it is that of sliding; its error from scatter [1]"""
    @property
    def position_systematic(self) -> float:
        """its error from EI, contact and load train, common to all rises [1]"""
    @property
    def advance(self) -> Estimate:
        """length drawn in over the rise [m]"""
    @property
    def verdict(self) -> str:
        """sliding, as_if_stuck or undecided"""
    @property
    def compliant_position(self) -> float:
        """p of a stuck specimen on supports that give way as fitted [1]"""
    @property
    def compliant_deviation(self) -> float:
        """of the position from that, in standard errors [1]"""
    @property
    def compliant_rejected(self) -> bool:
        """that is too much: it slides all the same"""

class FitTeethTeethTable(Table[FitTeethTeeth]):
    first_row: Any
    last_row: Any
    length_before: Numbers
    length_after: Numbers
    q_before: Numbers
    q_after: Numbers
    slope: Objects
    stick_slope: Numbers
    slide_slope: Numbers
    position: Objects
    position_systematic: Numbers
    advance: Objects
    verdict: Objects
    compliant_position: Numbers
    compliant_deviation: Numbers
    compliant_rejected: Objects

class FitTeeth(Answer):
    """whether the specimen sticks or slides between the drops; null where that is not asked"""

    @property
    def confidence(self) -> float:
        """of each verdict, one-sided [1]"""
    @property
    def least_share(self) -> float:
        """of the stage's motion drawn in, below which a specimen is called stuck [1]"""
    @property
    def compliance(self) -> FitTeethCompliance:
        """of supports that give way"""
    @property
    def sliding(self) -> int:
        """rises that reject that the specimen is stuck"""
    @property
    def as_if_stuck(self) -> int:
        """rises as steep as if it were stuck"""
    @property
    def undecided(self) -> int:
        """rises that tell neither"""
    @property
    def too_short(self) -> int:
        """rises of fewer than four rows"""
    @property
    def unexplained(self) -> int:
        """rises whose middle no friction explains"""
    @property
    def teeth(self) -> FitTeethTeethTable:
        """the rises between drops"""

class FitSuspects(Answer):
    """points that need more friction than is plausible, at the bending stiffness stated"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def length(self) -> float:
        """drawn in, and the span [m]"""
    @property
    def mu(self) -> float:
        """friction that it needs [1]"""
    @property
    def mu_error(self) -> float:
        """its standard error [1]"""

class FitSuspectsTable(Table[FitSuspects]):
    row: Any
    length: Numbers
    mu: Numbers
    mu_error: Numbers

class FitSuspectCriteria(Answer):
    """how these were found"""

    @property
    def limit(self) -> float:
        """friction above it is implausible [1]"""
    @property
    def points_judged(self) -> int:
        """past a deflection of a tenth of the span"""
    @property
    def points_above_limit(self) -> int:
        """of these"""
    @property
    def points_above_limit_beyond_error(self) -> int:
        """of these by more than 1.96 standard errors"""
    @property
    def points_above_euler_bernoulli(self) -> int:
        """points past there with a force above 48 EI w/L³: the paper's criterion"""

class FitEnergy(Answer):
    """where the work went, from contact to failure, by the measured points at the bending stiffness of the fit"""

    @property
    def stage_work(self) -> float:
        """work of the stage [J]"""
    @property
    def bending(self) -> float:
        """stored in the bent specimen [J]"""
    @property
    def load_train(self) -> float:
        """stored in the load train [J]"""
    @property
    def friction(self) -> float:
        """heat of friction at the supports [J]"""
    @property
    def snaps(self) -> float:
        """set free by snaps beyond friction; of a measured test all that is lost in drops [J]"""
    @property
    def imbalance(self) -> float:
        """what the account does not close by [J]"""
    @property
    def work_of_fracture(self) -> float:
        """work on the specimen: area under force over deflection [J]"""
    @property
    def friction_share(self) -> float:
        """of it that went into friction and snaps [1]"""
    @property
    def remaining(self) -> float:
        """of it without friction and snaps [J]"""

class FitReplay(Answer):
    """the profile read off the curve, run forward"""

    @property
    def residual_rms(self) -> float:
        """by which the measured profile, run forward as a table, misses the force [N]"""
    @property
    def drops(self) -> int:
        """of the record"""
    @property
    def drops_reproduced(self) -> int:
        """of these at the same point"""

class FitCyclesBendingStiffness(Estimate):
    """EI at which friction is the same in loading and unloading"""

    @property
    def relative_to_nominal(self) -> float:
        """over that stated, or of the initial slope [1]"""

class FitCyclesCorrelation(Answer):
    """of the bumps of friction in the two directions, of all loops together"""

    @property
    def value(self) -> float:
        """Pearson's r of friction in the two directions, slow trends taken off [1]"""
    @property
    def low(self) -> float:
        """lower end of its 95 % interval [1]"""
    @property
    def high(self) -> float:
        """upper end of its 95 % interval [1]"""
    @property
    def effective_points(self) -> float:
        """independent places that the places are worth [1]"""

class FitCyclesBuildUpLength(Answer):
    """over which friction builds up after a reversal (Dahl); null where no reversal is seen"""

    @property
    def value(self) -> float:
        """length of sliding, both sides together [m]"""
    @property
    def standard_error(self) -> float:
        """from reversal to reversal; null of a single one [m]"""
    @property
    def least(self) -> float:
        """least that could be told [m]"""
    @property
    def reversals(self) -> int:
        """that it is read off"""
    @property
    def told(self) -> bool:
        """it is told from none"""

class FitCyclesLoopsLoading(Answer):
    """rows of the loading; null without one"""

    @property
    def first_row(self) -> int:
        """first row of the file"""
    @property
    def last_row(self) -> int:
        """last row of the file"""

class FitCyclesLoopsUnloading(Answer):
    """rows of the unloading; null without one"""

    @property
    def first_row(self) -> int:
        """first row of the file"""
    @property
    def last_row(self) -> int:
        """last row of the file"""

class FitCyclesLoopsCornersStart(Answer):
    """first point of the loading that slides"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def length(self) -> float:
        """drawn in, and the span [m]"""
    @property
    def q(self) -> float:
        """mobilised friction [1]"""

class FitCyclesLoopsCornersTurn(Answer):
    """where the stage turned back"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def length(self) -> float:
        """drawn in, and the span [m]"""
    @property
    def q(self) -> float:
        """mobilised friction [1]"""

class FitCyclesLoopsCornersSlidesBack(Answer):
    """where it began to slide out"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def length(self) -> float:
        """drawn in, and the span [m]"""
    @property
    def q(self) -> float:
        """mobilised friction [1]"""

class FitCyclesLoopsCornersEnd(Answer):
    """end of the unloading"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def length(self) -> float:
        """drawn in, and the span [m]"""
    @property
    def q(self) -> float:
        """mobilised friction [1]"""

class FitCyclesLoopsCorners(Answer):
    """of the loop in friction over length; null where it has none"""

    @property
    def start(self) -> FitCyclesLoopsCornersStart | None:
        """first point of the loading that slides"""
    @property
    def turn(self) -> FitCyclesLoopsCornersTurn | None:
        """where the stage turned back"""
    @property
    def slides_back(self) -> FitCyclesLoopsCornersSlidesBack | None:
        """where it began to slide out"""
    @property
    def end(self) -> FitCyclesLoopsCornersEnd | None:
        """end of the unloading"""

class FitCyclesLoopsCorrelation(Answer):
    """of the bumps of friction in the two directions"""

    @property
    def value(self) -> float:
        """Pearson's r of friction in the two directions, slow trends taken off [1]"""
    @property
    def low(self) -> float:
        """lower end of its 95 % interval [1]"""
    @property
    def high(self) -> float:
        """upper end of its 95 % interval [1]"""
    @property
    def effective_points(self) -> float:
        """independent places that the places are worth [1]"""

class FitCyclesLoopsEnergy(Answer):
    """work at the supports' side, past the deflection at which friction shows"""

    @property
    def loading(self) -> float:
        """put in: the apparent work of fracture of this loading [J]"""
    @property
    def unloading(self) -> float:
        """given back; null of a loop that was not unloaded [J]"""
    @property
    def stored(self) -> float:
        """kept by bending, from where the loop begins to where it ends [J]"""
    @property
    def lost(self) -> float:
        """area of the loop less what is stored; null of one that is not closed, or was not loaded [J]"""
    @property
    def lost_share(self) -> float:
        """lost over loading [1]"""
    @property
    def friction(self) -> float:
        """heat of friction where it slides [J]"""

class FitCyclesLoopsProfile(Answer):
    """friction along the specimen as both directions support it"""

    @property
    def length(self) -> float:
        """drawn in, and the span [m]"""
    @property
    def drawn_in(self) -> float:
        """length drawn in over both supports [m]"""
    @property
    def position(self) -> float:
        """half of length: of the support along the specimen, from midspan, on edges [m]"""
    @property
    def mu(self) -> float:
        """friction there [1]"""
    @property
    def mu_error(self) -> float:
        """its standard error [1]"""

class FitCyclesLoopsProfileTable(Table[FitCyclesLoopsProfile]):
    length: Numbers
    drawn_in: Numbers
    position: Numbers
    mu: Numbers
    mu_error: Numbers

class FitCyclesLoops(Answer):
    """each loading with the unloading after it"""

    @property
    def first_row(self) -> int:
        """first row of the file"""
    @property
    def last_row(self) -> int:
        """last row of the file"""
    @property
    def loading(self) -> FitCyclesLoopsLoading | None:
        """rows of the loading; null without one"""
    @property
    def unloading(self) -> FitCyclesLoopsUnloading | None:
        """rows of the unloading; null without one"""
    @property
    def contact(self) -> Estimate:
        """stage position of the contact [m]"""
    @property
    def corners(self) -> FitCyclesLoopsCorners:
        """of the loop in friction over length; null where it has none"""
    @property
    def stick_advance(self) -> float:
        """drawn in while it should stick, after the turn: 0 in the model [m]"""
    @property
    def places(self) -> int:
        """at which the directions are compared"""
    @property
    def mu_in(self) -> Estimate | None:
        """friction sliding in, mean over the places [1]"""
    @property
    def mu_out(self) -> Estimate | None:
        """friction sliding out, likewise [1]"""
    @property
    def mean_difference(self) -> Estimate | None:
        """of the two, after EI and contact were chosen so that they agree [1]"""
    @property
    def rms_difference(self) -> Estimate | None:
        """of the two from place to place [1]"""
    @property
    def correlation(self) -> FitCyclesLoopsCorrelation | None:
        """of the bumps of friction in the two directions"""
    @property
    def energy(self) -> FitCyclesLoopsEnergy:
        """work at the supports' side, past the deflection at which friction shows"""
    @property
    def replay_rms(self) -> float:
        """residuals of one profile for all loops run forward, of the greatest force [1]"""
    @property
    def profile(self) -> FitCyclesLoopsProfileTable:
        """friction along the specimen as both directions support it"""

class FitCyclesLoopsTable(Table[FitCyclesLoops]):
    first_row: Any
    last_row: Any
    loading: Objects
    unloading: Objects
    contact: Objects
    corners: Objects
    stick_advance: Numbers
    places: Any
    mu_in: Objects
    mu_out: Objects
    mean_difference: Objects
    rms_difference: Objects
    correlation: Objects
    energy: Objects
    replay_rms: Numbers
    profile: Objects

class FitCyclesLoadingStiffness(Answer):
    """of each loading, against the first"""

    @property
    def status(self) -> str:
        """ok, reference (the first), or why it is not compared: loaded_too_little, window_not_covered, too_few_points, not_rising, still_drawn_in,
        no_reference"""
    @property
    def rows(self) -> Numbers | None:
        """first and last row of the file in the window [1]"""
    @property
    def slope(self) -> Estimate | None:
        """force over deflection in the window, its error from scatter [N/m]"""
    @property
    def ratio(self) -> Estimate | None:
        """to the slope of the first loading, its error from scatter [1]"""
    @property
    def ratio_systematic(self) -> float:
        """half the difference of the ratios in the lower and in the upper half of the window [1]"""
    @property
    def verdict(self) -> str | None:
        """damaged, not_damaged or undecided"""

class FitCyclesLoadingStiffnessTable(Table[FitCyclesLoadingStiffness]):
    status: Objects
    rows: Objects
    slope: Objects
    ratio: Objects
    ratio_systematic: Numbers
    verdict: Objects

class FitCyclesProfile(Answer):
    """friction along the specimen, of all loops"""

    @property
    def length(self) -> float:
        """drawn in, and the span [m]"""
    @property
    def drawn_in(self) -> float:
        """length drawn in over both supports [m]"""
    @property
    def position(self) -> float:
        """half of length: of the support along the specimen, from midspan, on edges [m]"""
    @property
    def mu(self) -> float:
        """friction there [1]"""

class FitCyclesProfileTable(Table[FitCyclesProfile]):
    length: Numbers
    drawn_in: Numbers
    position: Numbers
    mu: Numbers

class FitCyclesPoints(Answer):
    """mobilised friction, point by point"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def length(self) -> float:
        """drawn in, and the span [m]"""
    @property
    def q(self) -> float:
        """mobilised friction: μ sliding in, −μ sliding out, within these when stuck [1]"""
    @property
    def q_error(self) -> float:
        """its standard error: noise, EI and contact [1]"""
    @property
    def motion(self) -> str:
        """slip_in, slip_out or stick"""

class FitCyclesPointsTable(Table[FitCyclesPoints]):
    row: Any
    length: Numbers
    q: Numbers
    q_error: Numbers
    motion: Objects

class FitCycles(Answer):
    """of a test that was unloaded; null otherwise"""

    @property
    def status(self) -> str:
        """ok, no_mirror (no part of the specimen slid both ways), too_few_points or not_converged"""
    @property
    def bending_stiffness(self) -> FitCyclesBendingStiffness | None:
        """EI at which friction is the same in loading and unloading [N m^2]"""
    @property
    def asymmetry(self) -> Estimate | None:
        """friction sliding in less that sliding out, left free beside EI and contacts [1]"""
    @property
    def correlation(self) -> FitCyclesCorrelation | None:
        """of the bumps of friction in the two directions, of all loops together"""
    @property
    def mu_in(self) -> float:
        """friction sliding in, mean over the places of all loops [1]"""
    @property
    def mu_out(self) -> float:
        """friction sliding out, likewise [1]"""
    @property
    def rms_difference(self) -> float:
        """of the two from place to place [1]"""
    @property
    def beyond_friction(self) -> bool | None:
        """asymmetry is larger than friction itself, and told from none: an error of the model"""
    @property
    def build_up_length(self) -> FitCyclesBuildUpLength | None:
        """over which friction builds up after a reversal (Dahl); null where no reversal is seen"""
    @property
    def force_noise(self) -> float:
        """standard deviation of one force reading [N]"""
    @property
    def loops(self) -> FitCyclesLoopsTable:
        """each loading with the unloading after it"""
    @property
    def loading_stiffness(self) -> FitCyclesLoadingStiffnessTable:
        """of each loading, against the first"""
    @property
    def profile(self) -> FitCyclesProfileTable:
        """friction along the specimen, of all loops"""
    @property
    def points(self) -> FitCyclesPointsTable:
        """mobilised friction, point by point"""

class FitBand(Answer):
    """friction along the specimen, by the fit"""

    @property
    def length(self) -> Numbers:
        """between the contacts [m]"""
    @property
    def drawn_in(self) -> Numbers:
        """length drawn in over both supports [m]"""
    @property
    def mean(self) -> Numbers:
        """friction there [1]"""
    @property
    def deviation(self) -> Numbers:
        """its standard deviation [1]"""

class FitScan(Answer):
    """what a wave of each length would add"""

    @property
    def wavelength(self) -> float:
        """of the wave [m]"""
    @property
    def log_evidence_gain(self) -> float:
        """ln of the evidence that it adds [1]"""

class FitScanTable(Table[FitScan]):
    wavelength: Numbers
    log_evidence_gain: Numbers

class FitSmallDeflectionChord(Answer):
    """of ISO 178; null where the record does not cover both strains"""

    @property
    def strain(self) -> Numbers:
        """flexural strains between which it is drawn [1]"""
    @property
    def deflection(self) -> Numbers:
        """deflections there, from the origin [m]"""
    @property
    def stiffness(self) -> Estimate:
        """force over deflection between them [N/m]"""
    @property
    def modulus(self) -> Estimate | None:
        """flexural modulus of the chord, as ISO 178 has it [Pa]"""

class FitSmallDeflectionWindow(Answer):
    """the straight part"""

    @property
    def from_(self) -> float:
        """where the straight part begins, in shares of of_force [1]"""
    @property
    def up_to(self) -> float:
        """where it ends, likewise [1]"""
    @property
    def of_force(self) -> float:
        """greatest force reached at a small deflection [N]"""
    @property
    def rows(self) -> Numbers:
        """first and last row of the file in it [1]"""

class FitSmallDeflection(Answer):
    """the numbers of the bending standards"""

    @property
    def status(self) -> str:
        """ok, or no_straight_part: no number is there then"""
    @property
    def stiffness(self) -> Estimate | None:
        """force over deflection, slope of the straight part [N/m]"""
    @property
    def bending_stiffness(self) -> Estimate | None:
        """EI = F L³/(48 δ); null without a span [N m^2]"""
    @property
    def modulus(self) -> Estimate | None:
        """flexural modulus F L³/(48 I δ); null without a section [Pa]"""
    @property
    def chord(self) -> FitSmallDeflectionChord | None:
        """of ISO 178; null where the record does not cover both strains"""
    @property
    def window(self) -> FitSmallDeflectionWindow | None:
        """the straight part"""
    @property
    def origin(self) -> Quantity | None:
        """deflection at which the straight part would meet zero force [m]"""
    @property
    def greatest_force(self) -> Quantity | None:
        """greatest force [N]"""
    @property
    def deflection(self) -> Quantity | None:
        """deflection there, from the origin [m]"""
    @property
    def stress(self) -> Quantity | None:
        """flexural stress there, F L depth/(8 I) [Pa]"""
    @property
    def strain(self) -> Quantity | None:
        """flexural strain there, 6 δ depth/L² [1]"""
    @property
    def deflection_large(self) -> bool | None:
        """it is beyond a tenth of the span: stress and strain of the standards do not hold"""
    @property
    def supports_share(self) -> float:
        """what rollers and thickness, left out, add to the stiffness between the deflections of chord or straight part, without friction [1]"""
    @property
    def modulus_less_supports(self) -> Estimate | None:
        """modulus of the chord, or else of the straight part, less that [Pa]"""
    @property
    def shear_share(self) -> float:
        """what shear, left out, adds to a small deflection [1]"""
    @property
    def over_fit(self) -> float:
        """bending stiffness of the straight part over that of the fit [1]"""
    @property
    def disagrees_with_fit(self) -> bool | None:
        """their 95 % intervals do not meet"""

class FitMeasurement(Answer):
    """what of the file is evaluated"""

    @property
    def rows(self) -> int:
        """of the file"""
    @property
    def first_row(self) -> int:
        """of the file that is evaluated"""
    @property
    def last_row(self) -> int:
        """of the file that is evaluated"""
    @property
    def rows_repeated(self) -> int:
        """rows that say what the row before says"""
    @property
    def rows_held(self) -> int:
        """rows whose force is held while the displacement moves on"""
    @property
    def rows_interpolated(self) -> int:
        """rows between readings"""
    @property
    def rows_per_point(self) -> int:
        """of the rest one in so many counts"""
    @property
    def ends_with(self) -> str:
        """what ends the loading that is evaluated: last_row, until, failure or turn"""

class FitPreparation(Answer):
    """from the file to the record, step by step"""

    @property
    def step(self) -> str:
        """columns, metadata, first, repeated, held, interpolated, sign, thinning, zero, compliance, end, turn, stage or contact"""
    @property
    def changed(self) -> bool:
        """numbers are not as in the file, or rows are left out"""
    @property
    def done(self) -> str:
        """what was done, in words"""
    @property
    def value(self) -> float:
        """taken off, applied or found [1]"""
    @property
    def uncertainty(self) -> float:
        """its standard deviation, where it is known [1]"""
    @property
    def unit(self) -> str | None:
        """of both"""
    @property
    def rows(self) -> Numbers | None:
        """first and last row of the file that it is about; null: all [1]"""
    @property
    def key(self) -> str | None:
        """what to write into the case for having it otherwise"""
    @property
    def flag(self) -> str | None:
        """the flag that says the same"""

class FitPreparationTable(Table[FitPreparation]):
    step: Objects
    changed: Objects
    done: Objects
    value: Numbers
    uncertainty: Numbers
    unit: Objects
    rows: Objects
    key: Objects
    flag: Objects

class FitContact(Answer):
    """where the specimen is first touched"""

    @property
    def source(self) -> str:
        """stated, found, or the first_point of the file"""
    @property
    def taken_off(self) -> float:
        """from stage and deflection [m]"""
    @property
    def line_offset(self) -> Estimate | None:
        """where a line through the first part of the curve meets zero force, from there [m]"""
    @property
    def initial_slope(self) -> Estimate | None:
        """of that line [N/m]"""

class FitNominalBendingStiffness(Answer):
    """what was known of EI beforehand"""

    @property
    def nominal(self) -> float:
        """EI as used beforehand [N m^2]"""
    @property
    def relative_error(self) -> float:
        """its standard deviation [1]"""
    @property
    def source(self) -> str:
        """stated, stated_without_uncertainty, initial_slope or mirror_symmetry"""

class FitDraws(Answer):
    """the profiles that --draws writes"""

    @property
    def bending_stiffness(self) -> Numbers:
        """EI that goes with each [N m^2]"""
    @property
    def unit(self) -> str:
        """of these"""

class FitNoise(Answer):
    """of the force"""

    @property
    def force(self) -> float:
        """standard deviation of one reading, by its quietest tenth [N]"""
    @property
    def force_step(self) -> float:
        """standard deviation of a step from row to row [N]"""
    @property
    def smallest_drop(self) -> float:
        """a fall in one step smaller than this counts as noise [N]"""

class FitProfile(Answer):
    """friction along the specimen, read off the curve point by point at the bending stiffness of the fit"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def stage(self) -> float:
        """stage position, from the contact [m]"""
    @property
    def deflection(self) -> float:
        """deflection at midspan [m]"""
    @property
    def force(self) -> float:
        """force measured [N]"""
    @property
    def length(self) -> float:
        """of the specimen's axis between the contacts [m]"""
    @property
    def drawn_in(self) -> float:
        """length drawn in over both supports [m]"""
    @property
    def imaged(self) -> float:
        """of the axis between the verticals through the supports, as a camera sees it [m]"""
    @property
    def position(self) -> float:
        """of the support along the specimen, from midspan [m]"""
    @property
    def mu(self) -> float:
        """mobilised friction: the coefficient of friction while the specimen slides [1]"""
    @property
    def mu_error(self) -> float:
        """its standard error [1]"""
    @property
    def mu_error_force(self) -> float:
        """the part of it from the noise of the force [1]"""
    @property
    def mu_error_bending_stiffness(self) -> float:
        """the part of it from EI, which moves all points together [1]"""
    @property
    def mu_error_contact(self) -> float:
        """the part of it from the contact point, likewise [1]"""

class FitProfileTable(Table[FitProfile]):
    row: Any
    stage: Numbers
    deflection: Numbers
    force: Numbers
    length: Numbers
    drawn_in: Numbers
    imaged: Numbers
    position: Numbers
    mu: Numbers
    mu_error: Numbers
    mu_error_force: Numbers
    mu_error_bending_stiffness: Numbers
    mu_error_contact: Numbers

class FitProvenanceInputs(Answer):
    """files that were read"""

    @property
    def name(self) -> str:
        """as it was given"""
    @property
    def bytes(self) -> int | None:
        """null of standard input"""
    @property
    def sha256(self) -> str | None:
        """null of standard input"""

class FitProvenanceInputsTable(Table[FitProvenanceInputs]):
    name: Objects
    bytes: Any
    sha256: Objects

class FitProvenanceOptions(Answer):
    """of the analysis"""

    @property
    def model(self) -> str:
        """of friction"""
    @property
    def false_alarms(self) -> float:
        """drops to be expected in a test without slips [1]"""
    @property
    def suspect_limit(self) -> float:
        """friction above it is implausible [1]"""
    @property
    def check_stability(self) -> bool:
        """whether it was asked for"""

class FitProvenance(Answer):
    """what to give to the same version for the same answer"""

    @property
    def program(self) -> str:
        """flexslip"""
    @property
    def version(self) -> str:
        """its version"""
    @property
    def inputs(self) -> FitProvenanceInputsTable:
        """files that were read"""
    @property
    def options(self) -> FitProvenanceOptions:
        """of the analysis"""
    @property
    def case(self) -> str:
        """as TOML, also where it was given by flags"""

class FitFields(Answer):
    """What a measured test shows."""

    @property
    def status(self) -> str:
        """ok, or why there is no answer: too_few_points, not_explained, no_initial_slope"""
    @property
    def name(self) -> str:
        """of the test"""
    @property
    def units(self) -> FitUnits:
        """of plain numbers"""
    @property
    def model(self) -> str | None:
        """of friction: roughness, constant, drift, sinusoid or sinusoids"""
    @property
    def category(self) -> str:
        """of the sawtooth: clear, nominal or none"""
    @property
    def suspect(self) -> bool:
        """its standing is suspect or untrusted, or no sliding explains it"""
    @property
    def stiffness_over_initial_slope(self) -> float:
        """bending stiffness used over that of the initial slope [1]"""
    @property
    def force_over_frictionless(self) -> FitForceOverFrictionless:
        """the force over that without friction, past a tenth of the span; below 1, no friction explains it"""
    @property
    def model_implausible(self) -> bool:
        """no sliding with friction gives such a record"""
    @property
    def stiffness_implausible(self) -> bool:
        """the bending stiffness is not that of the initial slope, by more than 40 % and twice its error"""
    @property
    def parameters(self) -> FitParameters:
        """what was fitted; those of the model that the fit is of"""
    @property
    def friction_read(self) -> FitFrictionRead:
        """friction read off the curve point by point, at the bending stiffness of the fit: quantiles of mu in profile"""
    @property
    def residual_rms(self) -> float:
        """by which the mean of the fit, run forward, misses the force [N]"""
    @property
    def checks(self) -> FitChecksTable:
        """what the fit is held against; numbers of a check are those that it has"""
    @property
    def wave(self) -> FitWave | None:
        """the likeliest wave, claimed or not; null without one"""
    @property
    def one_side_at_a_time(self) -> FitOneSideAtATimeTable:
        """lengths along the specimen if it slid over one support at a time"""
    @property
    def explanations(self) -> FitExplanationsTable:
        """that the answer averages over, likeliest first"""
    @property
    def snaps(self) -> FitSnapsTable:
        """of the mean of the fit, run forward"""
    @property
    def judgement(self) -> FitJudgement | None:
        """what the test comes to when all is weighed"""
    @property
    def surface(self) -> FitSurface | None:
        """that would explain how friction varies; null where it does not"""
    @property
    def bending(self) -> FitBending:
        """how far the specimen was strained"""
    @property
    def imaged_length(self) -> FitImagedLength | None:
        """lengths that were imaged, against those read off the force; null without any"""
    @property
    def slip_or_crack(self) -> FitSlipOrCrack | None:
        """what the rises between the drops say of them; null where these are too few"""
    @property
    def drops(self) -> FitDropsTable:
        """of the force"""
    @property
    def slips(self) -> FitSlips:
        """the drops that can be slips by the bending stiffness stated, read at that of the fit"""
    @property
    def teeth(self) -> FitTeeth | None:
        """whether the specimen sticks or slides between the drops; null where that is not asked"""
    @property
    def suspects(self) -> FitSuspectsTable:
        """points that need more friction than is plausible, at the bending stiffness stated"""
    @property
    def suspect_criteria(self) -> FitSuspectCriteria:
        """how these were found"""
    @property
    def energy(self) -> FitEnergy | None:
        """where the work went, from contact to failure, by the measured points at the bending stiffness of the fit"""
    @property
    def replay(self) -> FitReplay | None:
        """the profile read off the curve, run forward"""
    @property
    def cycles(self) -> FitCycles | None:
        """of a test that was unloaded; null otherwise"""
    @property
    def band(self) -> FitBand:
        """friction along the specimen, by the fit"""
    @property
    def scan(self) -> FitScanTable:
        """what a wave of each length would add"""
    @property
    def small_deflection(self) -> FitSmallDeflection:
        """the numbers of the bending standards"""
    @property
    def measurement(self) -> FitMeasurement:
        """what of the file is evaluated"""
    @property
    def preparation(self) -> FitPreparationTable:
        """from the file to the record, step by step"""
    @property
    def contact(self) -> FitContact:
        """where the specimen is first touched"""
    @property
    def nominal_bending_stiffness(self) -> FitNominalBendingStiffness:
        """what was known of EI beforehand"""
    @property
    def draws(self) -> FitDraws:
        """the profiles that --draws writes"""
    @property
    def noise(self) -> FitNoise:
        """of the force"""
    @property
    def profile(self) -> FitProfileTable:
        """friction along the specimen, read off the curve point by point at the bending stiffness of the fit"""
    @property
    def provenance(self) -> FitProvenance:
        """what to give to the same version for the same answer"""

class SimulationUnits(Answer):
    """of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class SimulationPath(Answer):
    """point by point"""

    @property
    def stage(self) -> float:
        """stage position [m]"""
    @property
    def deflection(self) -> float:
        """deflection at midspan [m]"""
    @property
    def force(self) -> float:
        """force [N]"""
    @property
    def length(self) -> float:
        """of the specimen's axis between the contacts [m]"""
    @property
    def q(self) -> float:
        """mobilised friction [1]"""
    @property
    def motion(self) -> str:
        """stick, slip_in, slip_out, snap, crack, apart (the nose lifts off), rolls (on loose rollers)"""
    @property
    def drawn_in(self) -> float:
        """what has slid past the first contacts, over both supports [m]"""
    @property
    def imaged(self) -> float:
        """of the axis between the verticals through the supports, as a camera sees it [m]"""
    @property
    def strain(self) -> float:
        """bending strain of the surface at midspan [1]"""
    @property
    def stress(self) -> float:
        """bending stress there [Pa]"""
    @property
    def left(self) -> float:
        """drawn in over the first support [m]"""
    @property
    def right(self) -> float:
        """drawn in over the other [m]"""
    @property
    def stage_work(self) -> float:
        """work of the stage [J]"""
    @property
    def bending(self) -> float:
        """stored in the bent specimen [J]"""
    @property
    def load_train(self) -> float:
        """stored in the load train [J]"""
    @property
    def friction(self) -> float:
        """heat of friction at the supports [J]"""
    @property
    def snaps(self) -> float:
        """set free by snaps beyond friction [J]"""
    @property
    def cracks(self) -> float:
        """set free by cracks [J]"""

class SimulationPathTable(Table[SimulationPath]):
    stage: Numbers
    deflection: Numbers
    force: Numbers
    length: Numbers
    q: Numbers
    motion: Objects
    drawn_in: Numbers
    imaged: Numbers
    strain: Numbers
    stress: Numbers
    left: Numbers
    right: Numbers
    stage_work: Numbers
    bending: Numbers
    load_train: Numbers
    friction: Numbers
    snaps: Numbers
    cracks: Numbers

class SimulationSnaps(Answer):
    """of the specimen"""

    @property
    def stage(self) -> float:
        """stage position, which does not change on the way [m]"""
    @property
    def deflection_before(self) -> float:
        """deflection before it [m]"""
    @property
    def deflection_after(self) -> float:
        """deflection after it [m]"""
    @property
    def force_before(self) -> float:
        """force before it [N]"""
    @property
    def force_after(self) -> float:
        """force after it [N]"""
    @property
    def length_before(self) -> float:
        """drawn in before it, and the span [m]"""
    @property
    def length_after(self) -> float:
        """drawn in after it, and the span [m]"""
    @property
    def friction(self) -> float:
        """heat of friction in it [J]"""
    @property
    def released(self) -> float:
        """energy that it sets free beyond friction [J]"""

class SimulationSnapsTable(Table[SimulationSnaps]):
    stage: Numbers
    deflection_before: Numbers
    deflection_after: Numbers
    force_before: Numbers
    force_after: Numbers
    length_before: Numbers
    length_after: Numbers
    friction: Numbers
    released: Numbers

class SimulationCracks(Answer):
    """as stated, where they opened"""

    @property
    def stage(self) -> float:
        """stage position, which does not change on the way [m]"""
    @property
    def deflection_before(self) -> float:
        """deflection before it [m]"""
    @property
    def deflection_after(self) -> float:
        """deflection after it [m]"""
    @property
    def force_before(self) -> float:
        """force before it [N]"""
    @property
    def force_after(self) -> float:
        """force after it [N]"""
    @property
    def left(self) -> float:
        """of the first bending stiffness after it [1]"""
    @property
    def released(self) -> float:
        """energy that the crack sets free [J]"""

class SimulationCracksTable(Table[SimulationCracks]):
    stage: Numbers
    deflection_before: Numbers
    deflection_after: Numbers
    force_before: Numbers
    force_after: Numbers
    left: Numbers
    released: Numbers

class SimulationLegs(Answer):
    """from turn to turn of the stage: by how much each energy changes"""

    @property
    def direction(self) -> str:
        """loading or unloading"""
    @property
    def from_(self) -> float:
        """stage position where it begins [m]"""
    @property
    def to(self) -> float:
        """stage position where it ends [m]"""
    @property
    def stage_work(self) -> float:
        """work of the stage [J]"""
    @property
    def bending(self) -> float:
        """stored in the bent specimen [J]"""
    @property
    def load_train(self) -> float:
        """stored in the load train [J]"""
    @property
    def friction(self) -> float:
        """heat of friction at the supports [J]"""
    @property
    def snaps(self) -> float:
        """set free by snaps beyond friction [J]"""
    @property
    def cracks(self) -> float:
        """set free by cracks [J]"""
    @property
    def work_of_fracture(self) -> float:
        """work on the specimen [J]"""

class SimulationLegsTable(Table[SimulationLegs]):
    direction: Objects
    from_: Numbers
    to: Numbers
    stage_work: Numbers
    bending: Numbers
    load_train: Numbers
    friction: Numbers
    snaps: Numbers
    cracks: Numbers
    work_of_fracture: Numbers

class SimulationEnergy(Answer):
    """where the work went, from the start to the end"""

    @property
    def stage_work(self) -> float:
        """work of the stage [J]"""
    @property
    def bending(self) -> float:
        """stored in the bent specimen [J]"""
    @property
    def load_train(self) -> float:
        """stored in the load train [J]"""
    @property
    def friction(self) -> float:
        """heat of friction at the supports [J]"""
    @property
    def snaps(self) -> float:
        """set free by snaps beyond friction; of a measured test all that is lost in drops [J]"""
    @property
    def imbalance(self) -> float:
        """what the account does not close by [J]"""
    @property
    def cracks(self) -> float:
        """set free by cracks [J]"""
    @property
    def work_of_fracture(self) -> float:
        """work on the specimen: area under force over deflection [J]"""
    @property
    def friction_share(self) -> float:
        """of it that went into friction and snaps [1]"""
    @property
    def remaining(self) -> float:
        """of it without friction and snaps [J]"""

class SimulationFields(Answer):
    """What a test would measure."""

    @property
    def status(self) -> str:
        """ok, or why the path ends before its programme: slipped_through, contact_lost, not_computable (on loose rollers)"""
    @property
    def units(self) -> SimulationUnits:
        """of plain numbers"""
    @property
    def path(self) -> SimulationPathTable:
        """point by point"""
    @property
    def snaps(self) -> SimulationSnapsTable:
        """of the specimen"""
    @property
    def cracks(self) -> SimulationCracksTable:
        """as stated, where they opened"""
    @property
    def wraps_nose_from(self) -> float:
        """stage position from which the specimen wraps the nose; null where it does not [m]"""
    @property
    def legs(self) -> SimulationLegsTable:
        """from turn to turn of the stage: by how much each energy changes"""
    @property
    def energy(self) -> SimulationEnergy:
        """where the work went, from the start to the end"""

class ProfileUnits(Answer):
    """of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class ProfileBendingStiffness(Answer):
    """as used"""

    @property
    def value(self) -> float:
        """EI [N m^2]"""
    @property
    def relative_error(self) -> float:
        """its standard deviation [1]"""
    @property
    def source(self) -> str:
        """stated, stated_without_uncertainty, initial_slope or mirror_symmetry"""

class ProfileProfile(Answer):
    """friction along the specimen, point by point"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def stage(self) -> float:
        """stage position, from the contact [m]"""
    @property
    def deflection(self) -> float:
        """deflection at midspan [m]"""
    @property
    def force(self) -> float:
        """force measured [N]"""
    @property
    def length(self) -> float:
        """of the specimen's axis between the contacts [m]"""
    @property
    def drawn_in(self) -> float:
        """length drawn in over both supports [m]"""
    @property
    def imaged(self) -> float:
        """of the axis between the verticals through the supports, as a camera sees it [m]"""
    @property
    def position(self) -> float:
        """of the support along the specimen, from midspan [m]"""
    @property
    def mu(self) -> float:
        """mobilised friction: the coefficient of friction while the specimen slides [1]"""
    @property
    def mu_error(self) -> float:
        """its standard error [1]"""
    @property
    def mu_error_force(self) -> float:
        """the part of it from the noise of the force [1]"""
    @property
    def mu_error_bending_stiffness(self) -> float:
        """the part of it from EI, which moves all points together [1]"""
    @property
    def mu_error_contact(self) -> float:
        """the part of it from the contact point, likewise [1]"""

class ProfileProfileTable(Table[ProfileProfile]):
    row: Any
    stage: Numbers
    deflection: Numbers
    force: Numbers
    length: Numbers
    drawn_in: Numbers
    imaged: Numbers
    position: Numbers
    mu: Numbers
    mu_error: Numbers
    mu_error_force: Numbers
    mu_error_bending_stiffness: Numbers
    mu_error_contact: Numbers

class ProfileFields(Answer):
    """Friction point by point."""

    @property
    def status(self) -> str:
        """ok, or nothing_explained"""
    @property
    def units(self) -> ProfileUnits:
        """of plain numbers"""
    @property
    def bending_stiffness(self) -> ProfileBendingStiffness:
        """as used"""
    @property
    def contact_offset(self) -> float:
        """taken off stage and deflection [m]"""
    @property
    def force_noise(self) -> float:
        """standard deviation of one force reading [N]"""
    @property
    def last_row(self) -> int:
        """of the file that is evaluated"""
    @property
    def profile(self) -> ProfileProfileTable:
        """friction along the specimen, point by point"""
    @property
    def unexplained(self) -> Numbers:
        """rows of the file that no friction explains [1]"""

class DesignPhases(Answer):
    """what the phase of the friction decides; null where it decides nothing"""

    @property
    def count(self) -> int:
        """phases of the waves of friction that were tried"""
    @property
    def snapping(self) -> int:
        """of them, those with which the specimen snaps"""
    @property
    def least_largest_drop(self) -> float:
        """least of the largest drops, one for each phase [N]"""
    @property
    def greatest_largest_drop(self) -> float:
        """greatest of them [N]"""
    @property
    def critical_stiffness(self) -> float:
        """stiffness from which it snaps with none of them [N/m]"""

class DesignChanges(Answer):
    """with which the answer is the other one"""

    @property
    def parameter(self) -> str:
        """that changes, the others as they are"""
    @property
    def from_(self) -> float:
        """its value, in the unit of the parameter [1]"""
    @property
    def to(self) -> float:
        """its value then, likewise [1]"""
    @property
    def and_beyond(self) -> bool:
        """it stays so however far beyond"""
    @property
    def largest_drop_share(self) -> float:
        """largest drop then, of the greatest force [1]"""
    @property
    def words(self) -> str:
        """the change in a sentence"""

class DesignChangesTable(Table[DesignChanges]):
    parameter: Objects
    from_: Numbers
    to: Numbers
    and_beyond: Objects
    largest_drop_share: Numbers
    words: Objects

class DesignParameters(Answer):
    """of the design, in their units; null where infinite"""

    @property
    def mu0(self) -> float:
        """mean friction coefficient [1]"""
    @property
    def amplitude(self) -> float:
        """relative amplitude of friction [1]"""
    @property
    def wavelength(self) -> float:
        """wavelength of friction [m]"""
    @property
    def phase(self) -> float:
        """phase of friction [rad]"""
    @property
    def span(self) -> float:
        """support span [m]"""
    @property
    def diameter(self) -> float:
        """diameter of the specimen [m]"""
    @property
    def modulus(self) -> float:
        """flexural modulus [Pa]"""
    @property
    def stiffness(self) -> float:
        """load-train stiffness [N/m]"""
    @property
    def travel(self) -> float:
        """stage travel [m]"""
    @property
    def step(self) -> float:
        """step of the stage [m]"""
    @property
    def height(self) -> float:
        """height of the specimen [m]"""
    @property
    def width(self) -> float:
        """width of the specimen [m]"""
    @property
    def reference(self) -> float:
        """length at which the mean friction holds [m]"""
    @property
    def pin_friction(self) -> float:
        """friction between roller and pin [1]"""

class DesignUnits(Answer):
    """of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class DesignFields(Answer):
    """What a planned test will show."""

    @property
    def status(self) -> str:
        """ok, slipped_through or breaks (the outcomes are those up to there), impossible or not_computable"""
    @property
    def stage_reached(self) -> float:
        """stage position that the loading gets to [m]"""
    @property
    def deflection_reached(self) -> float:
        """deflection at that stage position [m]"""
    @property
    def snaps(self) -> int | None:
        """snaps of the specimen, however small"""
    @property
    def first_snap_stage(self) -> float:
        """stage position of the first snap; none without a snap [m]"""
    @property
    def first_snap_deflection(self) -> float:
        """deflection before the first snap; none without a snap [m]"""
    @property
    def first_snap_force_before(self) -> float:
        """force before the first snap; none without a snap [N]"""
    @property
    def first_snap_force_after(self) -> float:
        """force after the first snap; none without a snap [N]"""
    @property
    def drops(self) -> int | None:
        """falls of the force between readings, a run of them counting once: the teeth that the record shows"""
    @property
    def largest_drop(self) -> float:
        """largest fall of the force; 0 without drops [N]"""
    @property
    def mean_drop(self) -> float:
        """mean fall of the force; 0 without drops [N]"""
    @property
    def greatest_force(self) -> float:
        """greatest force [N]"""
    @property
    def greatest_strain(self) -> float:
        """greatest bending strain, at the surface at midspan; none without a section [1]"""
    @property
    def greatest_stress(self) -> float:
        """greatest bending stress, likewise [Pa]"""
    @property
    def work(self) -> float:
        """work measured on the specimen [J]"""
    @property
    def friction_heat(self) -> float:
        """part of the work that friction turns into heat at the supports [J]"""
    @property
    def released(self) -> float:
        """part of the work that the snaps set free beyond friction [J]"""
    @property
    def wraps_nose(self) -> bool:
        """the specimen is bent more sharply than the nose"""
    @property
    def friction_share(self) -> float:
        """of the work that went into friction and snaps [1]"""
    @property
    def answer(self) -> str:
        """whether the test shows a sawtooth, in a sentence"""
    @property
    def critical_stiffness(self) -> float:
        """stiffness at and above which this loading meets no snap; null if it snaps on every rig, 0 if on none [N/m]"""
    @property
    def pin_limit(self) -> float:
        """friction at which the rollers turn on their pins, the most that acts; null of others [1]"""
    @property
    def snaps_whatever_the_stiffness(self) -> bool:
        """even where the deflection itself is controlled"""
    @property
    def phases(self) -> DesignPhases | None:
        """what the phase of the friction decides; null where it decides nothing"""
    @property
    def changes(self) -> DesignChangesTable:
        """with which the answer is the other one"""
    @property
    def parameters(self) -> DesignParameters:
        """of the design, in their units; null where infinite"""
    @property
    def units(self) -> DesignUnits:
        """of plain numbers"""

class CampaignTestsParametersMu0(Estimate):
    """mean friction over the fibre seen"""

    @property
    def bound(self) -> bool:
        """the record does not tell it from 0: the upper end of its interval is a limit"""

class CampaignTestsParameters(Answer):
    """what was fitted; null what the fit has not"""

    @property
    def mu0(self) -> CampaignTestsParametersMu0:
        """mean friction over the fibre seen [1]"""
    @property
    def roughness(self) -> Estimate | None:
        """standard deviation of friction about its mean [1]"""
    @property
    def correlation_length(self) -> Estimate | None:
        """of the roughness along the specimen [m]"""
    @property
    def amplitude(self) -> Estimate | None:
        """of the likeliest wave of friction, relative to mu0 [1]"""
    @property
    def wavelength(self) -> Estimate | None:
        """of that wave, along the specimen [m]"""
    @property
    def surface_height(self) -> Estimate | None:
        """amplitude of the wave of the surface that would show that wave [m]"""
    @property
    def surface_slope(self) -> Estimate | None:
        """rms of the slopes that would show the friction [1]"""
    @property
    def phase(self) -> Estimate | None:
        """of that wave, at the length 0 [rad]"""
    @property
    def bending_stiffness(self) -> Estimate:
        """EI of the fit [N m^2]"""

class CampaignTestsWave(Answer):
    """whether the likeliest one is claimed"""

    @property
    def claimed(self) -> bool:
        """by the evidence; a wave that is not is only indicative"""
    @property
    def log_evidence(self) -> float:
        """ln of the evidence with a wave over that without [1]"""

class CampaignTestsFrictionRead(Answer):
    """friction read off the curve point by point, before any model of it"""

    @property
    def median(self) -> float:
        """half of the points lie below it [1]"""
    @property
    def low80(self) -> float:
        """a tenth of the points lie below it [1]"""
    @property
    def high80(self) -> float:
        """a tenth of the points lie above it [1]"""

class CampaignTests(Answer):
    """with an answer, in the order of the plan"""

    @property
    def name(self) -> str:
        """of the test"""
    @property
    def status(self) -> str:
        """ok, or why not: as fit, or failed"""
    @property
    def category(self) -> str | None:
        """of the sawtooth: clear, nominal, none"""
    @property
    def suspect(self) -> bool | None:
        """its standing is suspect or untrusted"""
    @property
    def standing(self) -> str | None:
        """sound, doubtful, suspect, untrusted: the remarks say why"""
    @property
    def drops_verdict(self) -> str | None:
        """not_by_cracks_alone, cracks, cannot_be_told; null without drops"""
    @property
    def model(self) -> str | None:
        """of friction, that was fitted"""
    @property
    def parameters(self) -> CampaignTestsParameters | None:
        """what was fitted; null what the fit has not"""
    @property
    def wave(self) -> CampaignTestsWave | None:
        """whether the likeliest one is claimed"""
    @property
    def friction_read(self) -> CampaignTestsFrictionRead | None:
        """friction read off the curve point by point, before any model of it"""
    @property
    def failed_checks(self) -> tuple[str, ...] | None:
        """residuals, drops, whiteness, nesting, friction, stability, stiffness"""
    @property
    def residual_rms(self) -> float:
        """measured force less the mean of the fit run forward, root mean square [N]"""
    @property
    def drops(self) -> int | None:
        """of the force, beyond its noise"""
    @property
    def work_of_fracture(self) -> float:
        """work on the specimen [J]"""
    @property
    def friction_share(self) -> float:
        """of it that went into friction and snaps; null of a test that is not trusted, or tells only a limit [1]"""
    @property
    def reason(self) -> str | None:
        """why the status is not ok"""
    @property
    def remarks(self) -> tuple[str, ...]:
        """what a reader of the table should know of it"""
    @property
    def file(self) -> str:
        """what describes the test"""

class CampaignTestsTable(Table[CampaignTests]):
    name: Objects
    status: Objects
    category: Objects
    suspect: Objects
    standing: Objects
    drops_verdict: Objects
    model: Objects
    parameters: Objects
    wave: Objects
    friction_read: Objects
    failed_checks: Objects
    residual_rms: Numbers
    drops: Any
    work_of_fracture: Numbers
    friction_share: Numbers
    reason: Objects
    remarks: Objects
    file: Objects

class CampaignCategoriesMu0(Answer):
    """mean friction, without tests that tell only a limit"""

    @property
    def mean(self) -> float:
        """over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest [1]"""
    @property
    def max(self) -> float:
        """largest [1]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesMu0Limit(Answer):
    """upper limits of the tests that tell only such"""

    @property
    def mean(self) -> float:
        """over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest [1]"""
    @property
    def max(self) -> float:
        """largest [1]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesAmplitude(Answer):
    """of one wave of friction, relative to mu0"""

    @property
    def mean(self) -> float:
        """over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest [1]"""
    @property
    def max(self) -> float:
        """largest [1]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesWavelength(Answer):
    """of that wave, along the specimen"""

    @property
    def mean(self) -> float:
        """over the tests [m]"""
    @property
    def min(self) -> float:
        """smallest [m]"""
    @property
    def max(self) -> float:
        """largest [m]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesSurfaceHeight(Answer):
    """amplitude of the wave of the surface that would show it"""

    @property
    def mean(self) -> float:
        """over the tests [m]"""
    @property
    def min(self) -> float:
        """smallest [m]"""
    @property
    def max(self) -> float:
        """largest [m]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesSurfaceSlope(Answer):
    """rms of the slopes that would show the friction"""

    @property
    def mean(self) -> float:
        """over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest [1]"""
    @property
    def max(self) -> float:
        """largest [1]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesWithSuspectsMu0(Answer):
    """mean friction, without tests that tell only a limit"""

    @property
    def mean(self) -> float:
        """over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest [1]"""
    @property
    def max(self) -> float:
        """largest [1]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesWithSuspectsMu0Limit(Answer):
    """upper limits of the tests that tell only such"""

    @property
    def mean(self) -> float:
        """over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest [1]"""
    @property
    def max(self) -> float:
        """largest [1]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesWithSuspectsAmplitude(Answer):
    """of one wave of friction, relative to mu0"""

    @property
    def mean(self) -> float:
        """over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest [1]"""
    @property
    def max(self) -> float:
        """largest [1]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesWithSuspectsWavelength(Answer):
    """of that wave, along the specimen"""

    @property
    def mean(self) -> float:
        """over the tests [m]"""
    @property
    def min(self) -> float:
        """smallest [m]"""
    @property
    def max(self) -> float:
        """largest [m]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesWithSuspectsSurfaceHeight(Answer):
    """amplitude of the wave of the surface that would show it"""

    @property
    def mean(self) -> float:
        """over the tests [m]"""
    @property
    def min(self) -> float:
        """smallest [m]"""
    @property
    def max(self) -> float:
        """largest [m]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesWithSuspectsSurfaceSlope(Answer):
    """rms of the slopes that would show the friction"""

    @property
    def mean(self) -> float:
        """over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest [1]"""
    @property
    def max(self) -> float:
        """largest [1]"""
    @property
    def n(self) -> int:
        """tests that it is taken over"""

class CampaignCategoriesWithSuspects(Answer):
    """the same with tests that are suspect"""

    @property
    def tests(self) -> int:
        """in the category"""
    @property
    def mu0(self) -> CampaignCategoriesWithSuspectsMu0:
        """mean friction, without tests that tell only a limit"""
    @property
    def mu0_limit(self) -> CampaignCategoriesWithSuspectsMu0Limit:
        """upper limits of the tests that tell only such"""
    @property
    def amplitude(self) -> CampaignCategoriesWithSuspectsAmplitude:
        """of one wave of friction, relative to mu0"""
    @property
    def wavelength(self) -> CampaignCategoriesWithSuspectsWavelength:
        """of that wave, along the specimen"""
    @property
    def waves_claimed(self) -> int:
        """of the tests with such a wave, those that claim it"""
    @property
    def surface_height(self) -> CampaignCategoriesWithSuspectsSurfaceHeight:
        """amplitude of the wave of the surface that would show it"""
    @property
    def surface_slope(self) -> CampaignCategoriesWithSuspectsSurfaceSlope:
        """rms of the slopes that would show the friction"""

class CampaignCategoriesBetweenSpecimensSpread(Estimate):
    """between specimens"""

    @property
    def bound(self) -> bool:
        """the records do not tell the specimens apart"""

class CampaignCategoriesBetweenSpecimensSpecimens(Answer):
    """each in the light of the others"""

    @property
    def test(self) -> str:
        """its name"""
    @property
    def value(self) -> float:
        """of the parameter, in the unit of typical [1]"""
    @property
    def standard_error(self) -> float:
        """of value [1]"""

class CampaignCategoriesBetweenSpecimensSpecimensTable(Table[CampaignCategoriesBetweenSpecimensSpecimens]):
    test: Objects
    value: Numbers
    standard_error: Numbers

class CampaignCategoriesBetweenSpecimens(Answer):
    """what specimens have in common, and how they differ, by parameter"""

    @property
    def tests(self) -> int:
        """whose records tell it"""
    @property
    def typical(self) -> Estimate:
        """mean of the specimens, of mu0; of the others the middle one [1]"""
    @property
    def differ_by(self) -> str:
        """what spread is: a standard deviation, or a factor either way"""
    @property
    def spread(self) -> CampaignCategoriesBetweenSpecimensSpread:
        """between specimens [1]"""
    @property
    def specimens(self) -> CampaignCategoriesBetweenSpecimensSpecimensTable:
        """each in the light of the others"""

class CampaignCategories(Answer):
    """clear, nominal, none and all; without tests that are suspect"""

    @property
    def tests(self) -> int:
        """in the category"""
    @property
    def mu0(self) -> CampaignCategoriesMu0:
        """mean friction, without tests that tell only a limit"""
    @property
    def mu0_limit(self) -> CampaignCategoriesMu0Limit:
        """upper limits of the tests that tell only such"""
    @property
    def amplitude(self) -> CampaignCategoriesAmplitude:
        """of one wave of friction, relative to mu0"""
    @property
    def wavelength(self) -> CampaignCategoriesWavelength:
        """of that wave, along the specimen"""
    @property
    def waves_claimed(self) -> int:
        """of the tests with such a wave, those that claim it"""
    @property
    def surface_height(self) -> CampaignCategoriesSurfaceHeight:
        """amplitude of the wave of the surface that would show it"""
    @property
    def surface_slope(self) -> CampaignCategoriesSurfaceSlope:
        """rms of the slopes that would show the friction"""
    @property
    def with_suspects(self) -> CampaignCategoriesWithSuspects:
        """the same with tests that are suspect"""
    @property
    def between_specimens(self) -> dict[str, CampaignCategoriesBetweenSpecimens]:
        """what specimens have in common, and how they differ, by parameter"""

class CampaignFailures(Answer):
    """tests without an answer"""

    @property
    def name(self) -> str:
        """of the test"""
    @property
    def status(self) -> str:
        """ok, or why not: as fit, or failed"""
    @property
    def reason(self) -> str:
        """why there is no answer"""
    @property
    def file(self) -> str:
        """what describes the test"""

class CampaignFailuresTable(Table[CampaignFailures]):
    name: Objects
    status: Objects
    reason: Objects
    file: Objects

class CampaignShared(Answer):
    """parameters that tests share"""

    @property
    def name(self) -> str:
        """of the parameter"""
    @property
    def unit(self) -> str:
        """of the estimate"""
    @property
    def value(self) -> float:
        """from several tests [1]"""
    @property
    def standard_error(self) -> float:
        """of value [1]"""
    @property
    def interval95(self) -> Numbers:
        """of value [1]"""
    @property
    def tests(self) -> int:
        """whose records tell it"""
    @property
    def chi_squared(self) -> float:
        """of the tests about it, with one freedom less than tests [1]"""
    @property
    def agreement(self) -> float:
        """probability that tests that do share it differ as much [1]"""

class CampaignSharedTable(Table[CampaignShared]):
    name: Objects
    unit: Objects
    value: Numbers
    standard_error: Numbers
    interval95: Objects
    tests: Any
    chi_squared: Numbers
    agreement: Numbers

class CampaignUnits(Answer):
    """of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class CampaignFields(Answer):
    """What many tests show."""

    @property
    def tests(self) -> CampaignTestsTable:
        """with an answer, in the order of the plan"""
    @property
    def categories(self) -> dict[str, CampaignCategories]:
        """clear, nominal, none and all; without tests that are suspect"""
    @property
    def failures(self) -> CampaignFailuresTable:
        """tests without an answer"""
    @property
    def shared(self) -> CampaignSharedTable:
        """parameters that tests share"""
    @property
    def units(self) -> CampaignUnits:
        """of plain numbers"""

class EquilibriumUnits(Answer):
    """of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class EquilibriumCurve(Answer):
    """of loading, where friction is fully mobilised"""

    @property
    def length(self) -> float:
        """of the specimen's axis between the contacts [m]"""
    @property
    def mu(self) -> float:
        """friction [1]"""
    @property
    def deflection(self) -> float:
        """at midspan [m]"""
    @property
    def force(self) -> float:
        """at midspan [N]"""
    @property
    def drawn_in(self) -> float:
        """what has slid past the first contacts, over both supports [m]"""

class EquilibriumCurveTable(Table[EquilibriumCurve]):
    length: Numbers
    mu: Numbers
    deflection: Numbers
    force: Numbers
    drawn_in: Numbers

class EquilibriumFields(Answer):
    """The curve of loading."""

    @property
    def status(self) -> str:
        """ok, or branch_ended: the curve ends where the force has fallen to zero"""
    @property
    def units(self) -> EquilibriumUnits:
        """of plain numbers"""
    @property
    def curve(self) -> EquilibriumCurveTable:
        """of loading, where friction is fully mobilised"""

class EquilibriumRegionUnits(Answer):
    """of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class EquilibriumRegionRegion(Answer):
    """all equilibria, with --region"""

    @property
    def length(self) -> float:
        """of the specimen's axis between the contacts [m]"""
    @property
    def q(self) -> float:
        """mobilised friction [1]"""
    @property
    def deflection(self) -> float:
        """at midspan [m]"""
    @property
    def force(self) -> float:
        """at midspan [N]"""
    @property
    def drawn_in(self) -> float:
        """what has slid past the first contacts, over both supports [m]"""

class EquilibriumRegionRegionTable(Table[EquilibriumRegionRegion]):
    length: Numbers
    q: Numbers
    deflection: Numbers
    force: Numbers
    drawn_in: Numbers

class EquilibriumRegionFields(Answer):
    """All equilibria."""

    @property
    def status(self) -> str:
        """ok, or branch_ended: the curve ends where the force has fallen to zero"""
    @property
    def units(self) -> EquilibriumRegionUnits:
        """of plain numbers"""
    @property
    def region(self) -> EquilibriumRegionRegionTable:
        """all equilibria, with --region"""

class ModulusChord(Answer):
    """of ISO 178; null where the record does not cover both strains"""

    @property
    def strain(self) -> Numbers:
        """flexural strains between which it is drawn [1]"""
    @property
    def deflection(self) -> Numbers:
        """deflections there, from the origin [m]"""
    @property
    def stiffness(self) -> Estimate:
        """force over deflection between them [N/m]"""
    @property
    def modulus(self) -> Estimate | None:
        """flexural modulus of the chord, as ISO 178 has it [Pa]"""

class ModulusWindow(Answer):
    """the straight part"""

    @property
    def from_(self) -> float:
        """where the straight part begins, in shares of of_force [1]"""
    @property
    def up_to(self) -> float:
        """where it ends, likewise [1]"""
    @property
    def of_force(self) -> float:
        """greatest force reached at a small deflection [N]"""
    @property
    def rows(self) -> Numbers:
        """first and last row of the file in it [1]"""

class ModulusPreparation(Answer):
    """from the file to the record, step by step"""

    @property
    def step(self) -> str:
        """columns, metadata, first, repeated, held, interpolated, sign, thinning, zero, compliance, end, turn, stage or contact"""
    @property
    def changed(self) -> bool:
        """numbers are not as in the file, or rows are left out"""
    @property
    def done(self) -> str:
        """what was done, in words"""
    @property
    def value(self) -> float:
        """taken off, applied or found [1]"""
    @property
    def uncertainty(self) -> float:
        """its standard deviation, where it is known [1]"""
    @property
    def unit(self) -> str | None:
        """of both"""
    @property
    def rows(self) -> Numbers | None:
        """first and last row of the file that it is about; null: all [1]"""
    @property
    def key(self) -> str | None:
        """what to write into the case for having it otherwise"""
    @property
    def flag(self) -> str | None:
        """the flag that says the same"""

class ModulusPreparationTable(Table[ModulusPreparation]):
    step: Objects
    changed: Objects
    done: Objects
    value: Numbers
    uncertainty: Numbers
    unit: Objects
    rows: Objects
    key: Objects
    flag: Objects

class ModulusFields(Answer):
    """The numbers of the bending standards."""

    @property
    def status(self) -> str:
        """ok, or no_straight_part: no number is there then"""
    @property
    def stiffness(self) -> Estimate | None:
        """force over deflection, slope of the straight part [N/m]"""
    @property
    def bending_stiffness(self) -> Estimate | None:
        """EI = F L³/(48 δ); null without a span [N m^2]"""
    @property
    def modulus(self) -> Estimate | None:
        """flexural modulus F L³/(48 I δ); null without a section [Pa]"""
    @property
    def chord(self) -> ModulusChord | None:
        """of ISO 178; null where the record does not cover both strains"""
    @property
    def window(self) -> ModulusWindow | None:
        """the straight part"""
    @property
    def origin(self) -> Quantity | None:
        """deflection at which the straight part would meet zero force [m]"""
    @property
    def greatest_force(self) -> Quantity | None:
        """greatest force [N]"""
    @property
    def deflection(self) -> Quantity | None:
        """deflection there, from the origin [m]"""
    @property
    def stress(self) -> Quantity | None:
        """flexural stress there, F L depth/(8 I) [Pa]"""
    @property
    def strain(self) -> Quantity | None:
        """flexural strain there, 6 δ depth/L² [1]"""
    @property
    def deflection_large(self) -> bool | None:
        """it is beyond a tenth of the span: stress and strain of the standards do not hold"""
    @property
    def supports_share(self) -> float:
        """what rollers and thickness, left out, add to the stiffness between the deflections of chord or straight part, without friction [1]"""
    @property
    def modulus_less_supports(self) -> Estimate | None:
        """modulus of the chord, or else of the straight part, less that [Pa]"""
    @property
    def shear_share(self) -> float:
        """what shear, left out, adds to a small deflection [1]"""
    @property
    def preparation(self) -> ModulusPreparationTable:
        """from the file to the record, step by step"""

class SurfaceUnits(Answer):
    """of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class SurfaceTrace(Answer):
    """as it was read"""

    @property
    def name(self) -> str:
        """as it was given"""
    @property
    def position(self) -> str | None:
        """column of the positions; null where their distance was stated"""
    @property
    def height(self) -> str:
        """column of the heights"""
    @property
    def heights(self) -> int:
        """that it has"""
    @property
    def step(self) -> float:
        """between heights [m]"""
    @property
    def field(self) -> float:
        """width of the trace [m]"""
    @property
    def unevenness(self) -> float:
        """greatest departure of a distance from their mean, relative [1]"""
    @property
    def interpolated(self) -> bool:
        """as distances differ by more than 1 %"""
    @property
    def notes(self) -> tuple[str, ...]:
        """what was decided about the file"""

class SurfaceTreatment(Answer):
    """of the heights"""

    @property
    def level(self) -> int:
        """degree of the polynomial taken off"""
    @property
    def cutoff(self) -> float:
        """of the Gaussian filter; null without one [m]"""
    @property
    def edge_radius(self) -> float:
        """of the edge that is drawn over it [m]"""
    @property
    def tapers(self) -> int:
        """of the spectrum"""

class SurfaceWaves(Answer):
    """that stand out of the spectrum, the highest first"""

    @property
    def wavelength(self) -> Estimate:
        """along the trace [m]"""
    @property
    def amplitude(self) -> Estimate:
        """of the height, half of crest to trough [m]"""
    @property
    def slope_amplitude(self) -> float:
        """2π amplitude over wavelength [1]"""
    @property
    def coherent(self) -> bool:
        """one phase all along the trace"""
    @property
    def phase(self) -> float:
        """of a coherent one, at position 0; null of others [rad]"""
    @property
    def p_value(self) -> float:
        """that a surface without waves shows one like it anywhere [1]"""

class SurfaceWavesTable(Table[SurfaceWaves]):
    wavelength: Objects
    amplitude: Objects
    slope_amplitude: Numbers
    coherent: Objects
    phase: Numbers
    p_value: Numbers

class SurfaceResolution(Answer):
    """of the wavelengths in question, of those found, or of a tenth of the field"""

    @property
    def wavelength(self) -> float:
        """in question [m]"""
    @property
    def heights_a_wave(self) -> float:
        """two are the least [1]"""
    @property
    def waves_in_field(self) -> float:
        """the paper asks for ten [1]"""
    @property
    def least_amplitude_by_pixels(self) -> float:
        """by the paper's rule, ten pixels from crest to trough; null where the pixel is not known [m]"""
    @property
    def least_amplitude_by_spectrum(self) -> float:
        """of a coherent wave that stands out of noise and roughness in 95 of 100 such traces [m]"""
    @property
    def pixel_wanted(self) -> float:
        """by the paper's rule, for a wave of the amplitude asked for or found [m]"""

class SurfaceResolutionTable(Table[SurfaceResolution]):
    wavelength: Numbers
    heights_a_wave: Numbers
    waves_in_field: Numbers
    least_amplitude_by_pixels: Numbers
    least_amplitude_by_spectrum: Numbers
    pixel_wanted: Numbers

class SurfaceFriction(Answer):
    """that its slopes predict; null where none is stated"""

    @property
    def base(self) -> float:
        """of the flat surface, as stated [1]"""
    @property
    def mean(self) -> float:
        """of what the slopes show [1]"""
    @property
    def deviation(self) -> float:
        """standard deviation of it [1]"""
    @property
    def low95(self) -> float:
        """a fortieth of the trace shows less [1]"""
    @property
    def high95(self) -> float:
        """a fortieth of the trace shows more [1]"""

class SurfaceFields(Answer):
    """What a height profile says of its surface."""

    @property
    def status(self) -> str:
        """ok, or noise: no surface is seen in it"""
    @property
    def units(self) -> SurfaceUnits:
        """of plain numbers"""
    @property
    def trace(self) -> SurfaceTrace:
        """as it was read"""
    @property
    def treatment(self) -> SurfaceTreatment:
        """of the heights"""
    @property
    def rms_height_of_trace(self) -> float:
        """of the levelled trace, noise included [m]"""
    @property
    def shortest(self) -> float:
        """wavelength that rms_height and rms_slope are told of [m]"""
    @property
    def longest(self) -> float:
        """likewise [m]"""
    @property
    def shortest_is(self) -> str:
        """noise: where it is as great as the surface; five_steps; stated"""
    @property
    def rms_height(self) -> Estimate | None:
        """of the surface, of wavelengths between these, without noise [m]"""
    @property
    def rms_slope(self) -> Estimate | None:
        """likewise [1]"""
    @property
    def rms_slope_of_edge(self) -> float:
        """of the path of the edge, from height to height; null of a sharp one [1]"""
    @property
    def correlation_length(self) -> Estimate | None:
        """where the correlation has fallen to 1/e; null beyond a tenth of the field [m]"""
    @property
    def noise(self) -> float:
        """standard deviation of a height, white [m]"""
    @property
    def noise_is(self) -> str:
        """stated, found or not_found"""
    @property
    def waves(self) -> SurfaceWavesTable:
        """that stand out of the spectrum, the highest first"""
    @property
    def pixel(self) -> float:
        """least difference of heights that is told; null if they are as fine as their noise [m]"""
    @property
    def pixel_is(self) -> str | None:
        """stated, heights: all are multiples of it; null without one"""
    @property
    def resolution(self) -> SurfaceResolutionTable:
        """of the wavelengths in question, of those found, or of a tenth of the field"""
    @property
    def friction(self) -> SurfaceFriction | None:
        """that its slopes predict; null where none is stated"""

class SweepCounts(Answer):
    """of them by status; null where they were not counted now"""

    @property
    def ok(self) -> int:
        """designs with this status"""
    @property
    def slipped_through(self) -> int:
        """designs with this status"""
    @property
    def impossible(self) -> int:
        """designs with this status"""
    @property
    def not_computable(self) -> int:
        """designs with this status"""
    @property
    def breaks(self) -> int:
        """designs with this status"""

class SweepFaults(Answer):
    """parts that are missing or damaged"""

    @property
    def file(self) -> str:
        """where the part should be, or what is damaged"""
    @property
    def rows(self) -> Numbers:
        """first and last of the sweep in it [1]"""
    @property
    def state(self) -> str:
        """missing or damaged"""

class SweepFaultsTable(Table[SweepFaults]):
    file: Objects
    rows: Objects
    state: Objects

class SweepFields(Answer):
    """What came of a sweep."""

    @property
    def status(self) -> str:
        """done, or incomplete: parts are missing or damaged"""
    @property
    def file(self) -> str | None:
        """that holds the sweep; null of a shard"""
    @property
    def rows(self) -> int | None:
        """designs of the sweep; null where that is not known"""
    @property
    def counts(self) -> SweepCounts | None:
        """of them by status; null where they were not counted now"""
    @property
    def faults(self) -> SweepFaultsTable:
        """parts that are missing or damaged"""
    @property
    def parts(self) -> str | None:
        """folder of a shard"""
    @property
    def shard(self) -> Numbers | None:
        """which of how many [1]"""
    @property
    def rows_found(self) -> int | None:
        """designs of the shard that were there already"""
    @property
    def rows_computed(self) -> int | None:
        """designs of the shard computed now"""

class ExportColumns(Answer):
    """of the specimen chosen"""

    @property
    def number(self) -> int:
        """of the column in the file, from 1"""
    @property
    def name(self) -> str:
        """as in the file"""
    @property
    def unit(self) -> str | None:
        """as in the file; null if there is none"""
    @property
    def role(self) -> str:
        """time, displacement, crosshead, deflection, force or other"""
    @property
    def first(self) -> Any:
        """what stands in its first row"""
    @property
    def last(self) -> Any:
        """what stands in its last row"""

class ExportColumnsTable(Table[ExportColumns]):
    number: Any
    name: Objects
    unit: Objects
    role: Objects
    first: Objects
    last: Objects

class ExportSpecimensColumns(Answer):
    """that it has"""

    @property
    def number(self) -> int:
        """of the column in the file, from 1"""
    @property
    def name(self) -> str:
        """as in the file"""
    @property
    def unit(self) -> str | None:
        """as in the file; null if there is none"""
    @property
    def role(self) -> str:
        """time, displacement, crosshead, deflection, force or other"""
    @property
    def first(self) -> Any:
        """what stands in its first row"""
    @property
    def last(self) -> Any:
        """what stands in its last row"""

class ExportSpecimensColumnsTable(Table[ExportSpecimensColumns]):
    number: Any
    name: Objects
    unit: Objects
    role: Objects
    first: Objects
    last: Objects

class ExportSpecimens(Answer):
    """that the file holds"""

    @property
    def name(self) -> str:
        """empty if the file names none"""
    @property
    def columns(self) -> ExportSpecimensColumnsTable:
        """that it has"""
    @property
    def rows(self) -> int:
        """that it has"""
    @property
    def first_line(self) -> int:
        """of the file, that its first row stands on"""
    @property
    def last_line(self) -> int:
        """of the file, that its last row stands on"""
    @property
    def metadata(self) -> dict[str, str]:
        """what the file says of it alone, under the file's names"""

class ExportSpecimensTable(Table[ExportSpecimens]):
    name: Objects
    columns: Objects
    rows: Any
    first_line: Any
    last_line: Any
    metadata: Objects

class ExportTest(Answer):
    """what was understood of that; null what was not stated"""

    @property
    def span(self) -> float:
        """between the supports [m]"""
    @property
    def diameter(self) -> float:
        """of the specimen [m]"""
    @property
    def width(self) -> float:
        """of the specimen [m]"""
    @property
    def thickness(self) -> float:
        """of the specimen [m]"""
    @property
    def rate(self) -> float:
        """speed of the crosshead, in m/s [1]"""

class ExportFields(Answer):
    """What an export holds."""

    @property
    def format(self) -> str:
        """Instron Bluehill, …, or table"""
    @property
    def sheet(self) -> str | None:
        """of the workbook (.xlsx) that was read; null of a text file"""
    @property
    def sheets(self) -> tuple[str, ...]:
        """of that workbook, in their order"""
    @property
    def encoding(self) -> str:
        """of the text"""
    @property
    def byte_order_mark(self) -> bool:
        """the file begins with one"""
    @property
    def delimiter(self) -> str | None:
        """between columns"""
    @property
    def decimal(self) -> str | None:
        """mark"""
    @property
    def thousands(self) -> str | None:
        """mark between them; null without one"""
    @property
    def quoted(self) -> bool:
        """cells stand in quotes"""
    @property
    def columns(self) -> ExportColumnsTable:
        """of the specimen chosen"""
    @property
    def rows(self) -> int:
        """of the specimen chosen"""
    @property
    def specimens(self) -> ExportSpecimensTable:
        """that the file holds"""
    @property
    def metadata(self) -> dict[str, str]:
        """what the file says of all, under its own names"""
    @property
    def test(self) -> ExportTest:
        """what was understood of that; null what was not stated"""
    @property
    def notes(self) -> tuple[str, ...]:
        """what was decided or left out"""
    @property
    def asks(self) -> tuple[str, ...]:
        """what the file does not say and an evaluation needs, with the flag that says it"""
    @property
    def repeat_with(self) -> str:
        """flags that make the same decisions again"""
