"""The answers and their types: written by tools/write-python-stubs."""
from typing import Any

import numpy as np
import numpy.typing as npt

from ._answers import Answer, Estimate, Quantity, Table

Numbers = npt.NDArray[np.float64]
Objects = npt.NDArray[np.object_]


class FitUnits(Answer):
    """units of plain numbers"""

    @property
    def length(self) -> str:
        """of lengths, stage positions and deflections"""
    @property
    def force(self) -> str:
        """of forces"""
    @property
    def energy(self) -> str:
        """of energies"""

class FitVerdict(Answer):
    """what the test comes to"""

    @property
    def code(self) -> str:
        """slip, undecided, crack, no_drops, check_input or no_answer"""
    @property
    def sentence(self) -> str:
        """the verdict and what belongs to it, as the screen has it"""

class FitAnswer(Answer):
    """the rows of the screen"""

    @property
    def label(self) -> str:
        """drops, slip or crack, friction, work, reload, stiffness or assumed"""
    @property
    def words(self) -> str:
        """what the screen says there"""

class FitAnswerTable(Table[FitAnswer]):
    label: Objects
    words: Objects

class FitFindingsNumbers(Answer):
    """what the sentence rests on"""

    @property
    def name(self) -> str:
        """what the number is"""
    @property
    def value(self) -> float:
        """in SI units, or reduced if the test is [1]"""

class FitFindingsNumbersTable(Table[FitFindingsNumbers]):
    name: Objects
    value: Numbers

class FitFindings(Answer):
    """all that was found out, the weightiest first"""

    @property
    def code(self) -> str:
        """a name that stays"""
    @property
    def severity(self) -> str:
        """refusal, suspicion, doubt, note, passed or unjudged"""
    @property
    def sentence(self) -> str:
        """what was found, as every door prints it"""
    @property
    def short_form(self) -> str:
        """a few words, for a table of many tests; empty where nothing speaks against the test"""
    @property
    def remedy(self) -> str:
        """what to do; empty where there is nothing to do"""
    @property
    def numbers(self) -> FitFindingsNumbersTable:
        """what the sentence rests on"""

class FitFindingsTable(Table[FitFindings]):
    code: Objects
    severity: Objects
    sentence: Objects
    short_form: Objects
    remedy: Objects
    numbers: Objects

class FitParametersMu0(Estimate):
    """mean friction over the specimen seen"""

    @property
    def bound(self) -> bool:
        """mu0 cannot be distinguished from 0, and the upper end of its interval is a limit"""

class FitParameters(Answer):
    """fitted parameters of the friction model"""

    @property
    def mu0(self) -> FitParametersMu0 | None:
        """mean friction over the specimen seen [1]"""
    @property
    def amplitude(self) -> Estimate | None:
        """amplitude of the likeliest wave of friction, relative to mu0 [1]"""
    @property
    def wavelength(self) -> Estimate | None:
        """wavelength of the likeliest wave of friction, along the specimen [m]"""
    @property
    def phase(self) -> Estimate | None:
        """phase of the likeliest wave of friction at the length 0 [rad]"""
    @property
    def phase_at_middle(self) -> Estimate | None:
        """phase of the wave at the reference [rad]"""
    @property
    def amplitude_2(self) -> Estimate | None:
        """amplitude of the second wave, relative to mu0 [1]"""
    @property
    def wavelength_2(self) -> Estimate | None:
        """wavelength of the second wave, along the specimen [m]"""
    @property
    def phase_2(self) -> Estimate | None:
        """phase of the second wave at the length 0 [rad]"""
    @property
    def drift(self) -> Estimate | None:
        """slope of friction along the specimen [1/m]"""
    @property
    def force_noise(self) -> Estimate | None:
        """standard deviation of a force reading, from the fit [N]"""
    @property
    def roughness(self) -> Estimate | None:
        """standard deviation of friction about its mean [1]"""
    @property
    def correlation_length(self) -> Estimate | None:
        """correlation length of friction along the specimen [m]"""
    @property
    def bending_stiffness(self) -> Estimate | None:
        """EI of the fit [N m^2]"""
    @property
    def reference(self) -> Estimate | None:
        """length between the contacts to which phase_at_middle refers, and mu0 if there is a drift or a wave [m]"""
    @property
    def contact_offset(self) -> Estimate:
        """stage position of the contact in the file, which is subtracted [m]"""

class FitFrictionRead(Answer):
    """friction read off the curve point by point, at the bending stiffness of the fit: quantiles of mu in profile"""

    @property
    def median(self) -> float:
        """friction below which half of the points lie [1]"""
    @property
    def low80(self) -> float:
        """friction below which a tenth of the points lie [1]"""
    @property
    def high80(self) -> float:
        """friction above which a tenth of the points lie [1]"""

class FitWave(Answer):
    """likeliest wave of friction, claimed or not; null without one"""

    @property
    def claimed(self) -> bool:
        """the evidence supports the wave, and it is shorter than a quarter of the specimen seen"""
    @property
    def log_evidence(self) -> float:
        """ln of the ratio of the evidence with and without a wave [1]"""
    @property
    def amplitude(self) -> Estimate:
        """amplitude of the likeliest wave of friction, relative to mu0 [1]"""
    @property
    def wavelength(self) -> Estimate:
        """wavelength of the likeliest wave of friction, along the specimen [m]"""
    @property
    def phase(self) -> Estimate:
        """phase of the likeliest wave of friction at the length 0 [rad]"""
    @property
    def phase_at_middle(self) -> Estimate:
        """phase of the wave at the reference [rad]"""

class FitExplanations(Answer):
    """explanations that the answer averages over, the likeliest first"""

    @property
    def kernel(self) -> str:
        """kernel of the roughness: exponential, matern_3_2, matern_5_2 or none"""
    @property
    def wavelengths(self) -> Numbers:
        """wavelengths of the waves in the explanation [m]"""
    @property
    def weight(self) -> float:
        """weight of the explanation; all weights add up to 1 [1]"""

class FitExplanationsTable(Table[FitExplanations]):
    kernel: Objects
    wavelengths: Objects
    weight: Numbers

class FitSnaps(Answer):
    """snaps of the mean of the fit, run forward"""

    @property
    def stage(self) -> float:
        """stage position, which stays the same [m]"""
    @property
    def deflection_before(self) -> float:
        """deflection before the jump [m]"""
    @property
    def deflection_after(self) -> float:
        """deflection after the jump [m]"""
    @property
    def force_before(self) -> float:
        """force before the jump [N]"""
    @property
    def force_after(self) -> float:
        """force after the jump [N]"""
    @property
    def length_before(self) -> float:
        """length between the supports before the snap: the span and what was pulled in [m]"""
    @property
    def length_after(self) -> float:
        """length between the supports after the snap: the span and what was pulled in [m]"""

class FitSnapsTable(Table[FitSnaps]):
    stage: Numbers
    deflection_before: Numbers
    deflection_after: Numbers
    force_before: Numbers
    force_after: Numbers
    length_before: Numbers
    length_after: Numbers

class FitJudgement(Answer):
    """verdict on the test when all is weighed"""

    @property
    def standing(self) -> str:
        """how far the answer can be trusted: sound, doubtful, suspect or untrusted"""
    @property
    def drops(self) -> str | None:
        """whether cracks alone can make the drops, judged by the rises and by a reload: not_by_cracks_alone, cracks or cannot_be_told; null without
        drops"""
    @property
    def stiffness_lost(self) -> float:
        """share of the stiffness lost, as the last comparable reload shows [1]"""
    @property
    def stiffness_lost_error(self) -> float:
        """standard error of stiffness_lost [1]"""
    @property
    def stiffness_loss_needed(self) -> float:
        """share of the stiffness that cracks alone would have to take away to make the drops; null without a reload [1]"""
    @property
    def stiffness_for_no_snap(self) -> float:
        """load-train stiffness above which the mean of the fit does not snap; null where less than half of the length that slid passed in slips
        [N/m]"""

class FitSurfaceProfile(Answer):
    """surface along the specimen"""

    @property
    def position(self) -> Numbers:
        """position from midspan [m]"""
    @property
    def slope(self) -> Numbers:
        """slope of the surface, from the mean of the fit [1]"""
    @property
    def height(self) -> Numbers:
        """height of the surface, from the mean of the fit, without tilt [m]"""

class FitSurfaceAgainstTrace(Answer):
    """comparison with a measured height trace; null without one"""

    @property
    def rms_slope(self) -> Estimate | None:
        """rms slope of the trace, of waves from shortest to longest [1]"""
    @property
    def shortest(self) -> float:
        """shortest wavelength in rms_slope [m]"""
    @property
    def longest(self) -> float:
        """longest wavelength in rms_slope [m]"""
    @property
    def correlation(self) -> float:
        """correlation of the slopes at the best place [1]"""
    @property
    def p_value(self) -> float:
        """probability that chance gives as high a correlation at any place, in either direction [1]"""
    @property
    def begin(self) -> float:
        """position on the trace at which the support stood at first, at the best place [m]"""
    @property
    def turned(self) -> bool:
        """the trace runs in the other direction at the best place"""

class FitSurface(Answer):
    """surface that would explain how friction varies; null if friction does not vary"""

    @property
    def rms_slope(self) -> Estimate:
        """rms slope that would explain the friction, of waves up to longest [1]"""
    @property
    def rms_height(self) -> Estimate:
        """rms height that would explain the friction, of waves up to longest [m]"""
    @property
    def longest(self) -> float:
        """longest wavelength in rms_slope and rms_height, a quarter of the specimen seen [m]"""
    @property
    def wave_height(self) -> Estimate | None:
        """amplitude of the wave of height that would explain the likeliest wave of friction; null without one [m]"""
    @property
    def pixel_wanted(self) -> float:
        """pixel needed to see the wave by the paper's rule, ten pixels from crest to trough [m]"""
    @property
    def profile(self) -> FitSurfaceProfile:
        """surface along the specimen"""
    @property
    def against_trace(self) -> FitSurfaceAgainstTrace | None:
        """comparison with a measured height trace; null without one"""

class FitBending(Answer):
    """how far the specimen was strained"""

    @property
    def greatest_strain(self) -> float:
        """greatest bending strain of the surface at midspan; null without a section [1]"""
    @property
    def greatest_stress(self) -> float:
        """greatest bending stress of the surface at midspan, at the fitted modulus; null without a section [Pa]"""
    @property
    def wraps_nose(self) -> bool:
        """the specimen was bent more sharply than the nose"""

class FitImagedLength(Answer):
    """imaged lengths compared with those read off the force; null without any"""

    @property
    def offset(self) -> float:
        """length from the force minus the imaged length, median over the points [m]"""
    @property
    def standard_error(self) -> float:
        """standard error of offset, if the points erred independently [m]"""
    @property
    def scatter(self) -> float:
        """scatter of the points about offset, 1.48 times the median absolute deviation [m]"""

class FitSlipOrCrack(Answer):
    """what the rises between the drops say about slips and cracks; null if there are too few"""

    @property
    def verdict(self) -> str:
        """whether cracks alone can make the drops: not_by_cracks_alone, cracks or cannot_be_told"""
    @property
    def margin(self) -> float:
        """D*: BIC of the best explanation by cracks minus BIC of the best by slips [1]"""
    @property
    def rises(self) -> int:
        """number of rises between drops that are judged"""
    @property
    def stiffer_rises(self) -> int:
        """number of judged rises that grow stiffer towards their end"""

class FitDrops(Answer):
    """drops of the force"""

    @property
    def row_before(self) -> int:
        """row of the file before the drop"""
    @property
    def row_after(self) -> int:
        """row of the file after the drop"""
    @property
    def stage(self) -> float:
        """stage position before the drop [m]"""
    @property
    def deflection_before(self) -> float:
        """deflection before the drop [m]"""
    @property
    def deflection_after(self) -> float:
        """deflection after the drop [m]"""
    @property
    def force_before(self) -> float:
        """force before the drop [N]"""
    @property
    def force_after(self) -> float:
        """force after the drop [N]"""
    @property
    def force_fall(self) -> float:
        """fall of the force in the drop [N]"""
    @property
    def significance(self) -> float:
        """fall of the force beyond that of the smooth curve, in standard deviations of the noise [1]"""
    @property
    def slip(self) -> str:
        """whether the drop can be a slip: possible, too_short, or not: unexplained, implausible, negative or moves_out"""
    @property
    def reading(self) -> str:
        """the same in words, as tables and page print it"""
    @property
    def pulled_in(self) -> Estimate:
        """length pulled in (both supports) if the drop is a slip [m]"""
    @property
    def mu_before(self) -> float:
        """friction before the drop, if it is a slip [1]"""
    @property
    def mu_after(self) -> float:
        """friction after the drop, if it is a slip [1]"""

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
    slip: Objects
    reading: Objects
    pulled_in: Objects
    mu_before: Numbers
    mu_after: Numbers

class FitSlipsSlips(Answer):
    """drops that can be slips, in the order of drops"""

    @property
    def length_before(self) -> float:
        """length between the supports before the slip: the span and what was pulled in [m]"""
    @property
    def length_after(self) -> float:
        """length between the supports after the slip: the span and what was pulled in [m]"""

class FitSlipsSlipsTable(Table[FitSlipsSlips]):
    length_before: Numbers
    length_after: Numbers

class FitSlips(Answer):
    """drops that can be slips at the stated bending stiffness, read off at that of the fit"""

    @property
    def median_spacing(self) -> float:
        """median length of specimen that passes over each support from the beginning of one slip to the next [m]"""
    @property
    def median_fall_of_mu(self) -> float:
        """median fall of friction in a slip [1]"""
    @property
    def slips(self) -> FitSlipsSlipsTable:
        """drops that can be slips, in the order of drops"""

class FitTeethCompliance(Estimate):
    """compliance of both supports together that would explain the slopes if the specimen were stuck"""

    @property
    def p_value(self) -> float:
        """probability of slopes that scatter at least as much about the compliance [1]"""

class FitTeethTeeth(Answer):
    """rises between drops"""

    @property
    def first_row(self) -> int:
        """first row of the rise in the file"""
    @property
    def last_row(self) -> int:
        """last row of the rise in the file"""
    @property
    def slope(self) -> Estimate:
        """mean slope of force over stage position in the rise [N/m]"""
    @property
    def position(self) -> Estimate:
        """position p of the slope between sliding (0) and sticking (1); its error from scatter [1]"""
    @property
    def position_systematic(self) -> float:
        """error of position from EI, contact and load train, common to all rises [1]"""
    @property
    def verdict(self) -> str:
        """what the specimen does during the rise: sliding, as_if_stuck or undecided"""

class FitTeethTeethTable(Table[FitTeethTeeth]):
    first_row: Any
    last_row: Any
    slope: Objects
    position: Objects
    position_systematic: Numbers
    verdict: Objects

class FitTeeth(Answer):
    """whether the specimen sticks or slides between the drops; null if that was not asked"""

    @property
    def compliance(self) -> FitTeethCompliance | None:
        """compliance of both supports together that would explain the slopes if the specimen were stuck [m/N]"""
    @property
    def too_short(self) -> int:
        """number of rises with fewer than four rows"""
    @property
    def teeth(self) -> FitTeethTeethTable:
        """rises between drops"""

class FitSuspects(Answer):
    """points that need implausibly high friction, at the stated bending stiffness"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def mu(self) -> float:
        """friction that the point needs [1]"""
    @property
    def mu_error(self) -> float:
        """standard error of mu [1]"""

class FitSuspectsTable(Table[FitSuspects]):
    row: Any
    mu: Numbers
    mu_error: Numbers

class FitEnergy(Answer):
    """where the work went, from contact to failure, computed from the measured points at the bending stiffness of the fit"""

    @property
    def stage_work(self) -> float:
        """work of the stage [J]"""
    @property
    def bending(self) -> float:
        """energy stored in the bent specimen [J]"""
    @property
    def load_train(self) -> float:
        """energy stored in the load train [J]"""
    @property
    def friction(self) -> float:
        """heat of friction at the supports [J]"""
    @property
    def snaps(self) -> float:
        """energy lost in drops beyond friction [J]"""
    @property
    def work_of_fracture(self) -> float:
        """work on the specimen: area under force over deflection [J]"""
    @property
    def friction_share(self) -> float:
        """share of the work of fracture that went into friction and snaps [1]"""

class FitReplay(Answer):
    """the profile read off the record, run forward"""

    @property
    def drops_reproduced(self) -> int:
        """drops of the record that the replay has at the same point"""

class FitCyclesCorrelation(Answer):
    """correlation of the bumps of friction in the two directions, over all loops"""

    @property
    def value(self) -> float:
        """Pearson's r of friction in the two directions, without slow trends [1]"""
    @property
    def low(self) -> float:
        """lower end of the 95 % interval of value [1]"""
    @property
    def high(self) -> float:
        """upper end of the 95 % interval of value [1]"""

class FitCyclesBuildUpLength(Estimate):
    """length of sliding over both supports in which friction builds up after a reversal (Dahl), its error from the scatter between reversals; null
    without a reversal"""

    @property
    def least(self) -> float:
        """smallest build-up length that could be detected [m]"""
    @property
    def told(self) -> bool | None:
        """the build-up length differs significantly from zero"""

class FitCyclesLoopsCorrelation(Answer):
    """correlation of the bumps of friction in the two directions"""

    @property
    def value(self) -> float:
        """Pearson's r of friction in the two directions, without slow trends [1]"""
    @property
    def low(self) -> float:
        """lower end of the 95 % interval of value [1]"""
    @property
    def high(self) -> float:
        """upper end of the 95 % interval of value [1]"""

class FitCyclesLoopsEnergy(Answer):
    """work on the specimen, beyond the deflection at which friction shows"""

    @property
    def loading(self) -> float:
        """work put in during loading, the apparent work of fracture [J]"""
    @property
    def unloading(self) -> float:
        """work given back during unloading; null if the loop was not unloaded [J]"""
    @property
    def lost(self) -> float:
        """loading minus unloading and the bending energy gained meanwhile; null if the loop is not closed or was not loaded [J]"""
    @property
    def friction(self) -> float:
        """heat of friction during sliding [J]"""

class FitCyclesLoops(Answer):
    """loops: each loading with the unloading that follows"""

    @property
    def loading(self) -> Numbers | None:
        """first and last row of the loading in the file; null without one [1]"""
    @property
    def unloading(self) -> Numbers | None:
        """first and last row of the unloading in the file; null without one [1]"""
    @property
    def contact(self) -> Estimate:
        """stage position of the contact [m]"""
    @property
    def mu_in(self) -> Estimate | None:
        """mean friction while sliding in, over the places [1]"""
    @property
    def mu_out(self) -> Estimate | None:
        """mean friction while sliding out, over the places [1]"""
    @property
    def rms_difference(self) -> Estimate | None:
        """root mean square difference between the two directions from place to place [1]"""
    @property
    def correlation(self) -> FitCyclesLoopsCorrelation | None:
        """correlation of the bumps of friction in the two directions"""
    @property
    def energy(self) -> FitCyclesLoopsEnergy:
        """work on the specimen, beyond the deflection at which friction shows"""
    @property
    def replay_rms(self) -> float:
        """rms residual of one profile for all loops, run forward, as a share of the greatest force [1]"""

class FitCyclesLoopsTable(Table[FitCyclesLoops]):
    loading: Objects
    unloading: Objects
    contact: Objects
    mu_in: Objects
    mu_out: Objects
    rms_difference: Objects
    correlation: Objects
    energy: Objects
    replay_rms: Numbers

class FitCyclesLoadingStiffness(Answer):
    """stiffness of each loading compared with the first"""

    @property
    def status(self) -> str:
        """whether the loading is compared: ok, reference (the first), or why not: loaded_too_little, window_not_covered, too_few_points, not_rising,
        still_drawn_in, no_reference"""
    @property
    def rows(self) -> Numbers | None:
        """first and last row of the window in the file [1]"""
    @property
    def slope(self) -> Estimate | None:
        """slope of force over deflection in the window; its error from scatter [N/m]"""
    @property
    def ratio(self) -> Estimate | None:
        """slope divided by that of the first loading; its error from scatter [1]"""
    @property
    def ratio_systematic(self) -> float:
        """half the difference between the ratios in the lower and the upper half of the window [1]"""
    @property
    def verdict(self) -> str | None:
        """whether the specimen lost stiffness: damaged, not_damaged or undecided"""

class FitCyclesLoadingStiffnessTable(Table[FitCyclesLoadingStiffness]):
    status: Objects
    rows: Objects
    slope: Objects
    ratio: Objects
    ratio_systematic: Numbers
    verdict: Objects

class FitCyclesProfile(Answer):
    """friction along the specimen, from all loops"""

    @property
    def length(self) -> float:
        """length between the supports: the span and what was pulled in [m]"""
    @property
    def mu(self) -> float:
        """friction at this place [1]"""

class FitCyclesProfileTable(Table[FitCyclesProfile]):
    length: Numbers
    mu: Numbers

class FitCyclesPoints(Answer):
    """mobilised friction, point by point"""

    @property
    def row(self) -> int:
        """row of the file"""
    @property
    def length(self) -> float:
        """length between the supports: the span and what was pulled in [m]"""
    @property
    def q(self) -> float:
        """mobilised friction: μ while sliding in, −μ while sliding out, in between while stuck [1]"""
    @property
    def motion(self) -> str:
        """how the specimen moves: slip_in, slip_out or stick"""

class FitCyclesPointsTable(Table[FitCyclesPoints]):
    row: Any
    length: Numbers
    q: Numbers
    motion: Objects

class FitCycles(Answer):
    """loading and unloading loops of a test that was unloaded; null otherwise"""

    @property
    def status(self) -> str:
        """whether the loops were evaluated: ok, no_mirror (no part of the specimen slid both ways), too_few_points or not_converged"""
    @property
    def bending_stiffness(self) -> Estimate | None:
        """EI at which friction is the same in loading and unloading [N m^2]"""
    @property
    def asymmetry(self) -> Estimate | None:
        """friction while sliding in minus friction while sliding out, fitted beside EI and contacts [1]"""
    @property
    def correlation(self) -> FitCyclesCorrelation | None:
        """correlation of the bumps of friction in the two directions, over all loops"""
    @property
    def build_up_length(self) -> FitCyclesBuildUpLength | None:
        """length of sliding over both supports in which friction builds up after a reversal (Dahl), its error from the scatter between reversals;
        null without a reversal [m]"""
    @property
    def loops(self) -> FitCyclesLoopsTable:
        """loops: each loading with the unloading that follows"""
    @property
    def loading_stiffness(self) -> FitCyclesLoadingStiffnessTable:
        """stiffness of each loading compared with the first"""
    @property
    def profile(self) -> FitCyclesProfileTable:
        """friction along the specimen, from all loops"""
    @property
    def points(self) -> FitCyclesPointsTable:
        """mobilised friction, point by point"""

class FitBand(Answer):
    """friction along the specimen, from the fit"""

    @property
    def length(self) -> Numbers:
        """length between the contacts [m]"""
    @property
    def mean(self) -> Numbers:
        """mean friction at this length [1]"""
    @property
    def deviation(self) -> Numbers:
        """standard deviation of friction at this length [1]"""

class FitSmallDeflection(Answer):
    """the straight part of the curve, beside the fit"""

    @property
    def over_fit(self) -> float:
        """bending stiffness of the straight part divided by that of the fit [1]"""

class FitMeasurement(Answer):
    """part of the file that is evaluated"""

    @property
    def rows(self) -> int:
        """rows of the file"""
    @property
    def first_row(self) -> int:
        """first row of the file that is evaluated"""
    @property
    def last_row(self) -> int:
        """last row of the file that is evaluated"""
    @property
    def ends_with(self) -> str:
        """what ends the evaluated loading: last_row, until, failure or turn"""

class FitPreparation(Answer):
    """steps from the file to the record"""

    @property
    def step(self) -> str:
        """name of the step: columns, metadata, first, repeated, held, interpolated, sign, thinning, zero, compliance, end, turn, stage or contact"""
    @property
    def changed(self) -> bool:
        """numbers differ from those in the file, or rows are left out"""
    @property
    def done(self) -> str:
        """what was done, in words"""
    @property
    def value(self) -> float:
        """value that was subtracted, applied or found [1]"""
    @property
    def uncertainty(self) -> float:
        """standard deviation of value, if it is known [1]"""
    @property
    def unit(self) -> str | None:
        """unit of value and uncertainty"""
    @property
    def rows(self) -> Numbers | None:
        """first and last row of the file that the step concerns; null for all [1]"""
    @property
    def key(self) -> str | None:
        """what to write into the case to have the step done otherwise"""
    @property
    def flag(self) -> str | None:
        """flag of the command line that has the step done otherwise"""

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
    """point of first contact with the specimen"""

    @property
    def source(self) -> str:
        """where the contact comes from: stated, found, or first_point of the file"""
    @property
    def line_offset(self) -> Estimate | None:
        """displacement, from the contact, at which a line through the first part of the curve meets zero force [m]"""

class FitNominalBendingStiffness(Answer):
    """what was known about EI before the fit"""

    @property
    def nominal(self) -> float:
        """EI known before the fit [N m^2]"""
    @property
    def relative_error(self) -> float:
        """relative standard deviation of EI [1]"""
    @property
    def source(self) -> str:
        """where EI comes from: stated, stated_without_uncertainty, initial_slope or mirror_symmetry"""

class FitDraws(Answer):
    """profiles that --draws writes"""

    @property
    def bending_stiffness(self) -> Numbers:
        """EI that belongs to each profile, in the unit of parameters.bending_stiffness [N m^2]"""

class FitNoise(Answer):
    """noise of the force"""

    @property
    def force(self) -> float:
        """standard deviation of one force reading, from the quietest tenth of the record [N]"""
    @property
    def smallest_drop(self) -> float:
        """smallest fall of the force in one step that counts as a drop [N]"""

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
        """length of the specimen's axis between the contacts [m]"""
    @property
    def drawn_in(self) -> float:
        """length pulled in (both supports) [m]"""
    @property
    def imaged(self) -> float:
        """length of the axis between the verticals through the supports, as a camera sees it [m]"""
    @property
    def mu(self) -> float:
        """mobilised friction: the coefficient of friction while the specimen slides [1]"""
    @property
    def mu_error(self) -> float:
        """standard error of mu [1]"""
    @property
    def mu_error_force(self) -> float:
        """part of mu_error from the noise of the force [1]"""
    @property
    def mu_error_bending_stiffness(self) -> float:
        """part of mu_error from EI, which moves all points together [1]"""
    @property
    def mu_error_contact(self) -> float:
        """part of mu_error from the contact point, which moves all points together [1]"""

class FitProfileTable(Table[FitProfile]):
    row: Any
    stage: Numbers
    deflection: Numbers
    force: Numbers
    length: Numbers
    drawn_in: Numbers
    imaged: Numbers
    mu: Numbers
    mu_error: Numbers
    mu_error_force: Numbers
    mu_error_bending_stiffness: Numbers
    mu_error_contact: Numbers

class FitProvenanceInputs(Answer):
    """files that were read"""

    @property
    def name(self) -> str:
        """name of the file, as it was given"""
    @property
    def sha256(self) -> str | None:
        """SHA-256 of the file; null for standard input"""

class FitProvenanceInputsTable(Table[FitProvenanceInputs]):
    name: Objects
    sha256: Objects

class FitProvenanceOptions(Answer):
    """options of the analysis"""

    @property
    def model(self) -> str:
        """friction model"""
    @property
    def false_alarms(self) -> float:
        """number of drops expected in a test without slips [1]"""
    @property
    def suspect_limit(self) -> float:
        """limit above which friction is implausible [1]"""
    @property
    def check_stability(self) -> bool:
        """whether the check of stability was asked for"""

class FitProvenance(Answer):
    """what the same version needs to give the same answer"""

    @property
    def version(self) -> str:
        """version of the program"""
    @property
    def inputs(self) -> FitProvenanceInputsTable:
        """files that were read"""
    @property
    def options(self) -> FitProvenanceOptions:
        """options of the analysis"""
    @property
    def case(self) -> str:
        """case as TOML, even if it was given by flags"""

class FitFields(Answer):
    """What a measured test shows."""

    @property
    def status(self) -> str:
        """ok, or why there is no answer: too_few_points, not_explained, no_initial_slope"""
    @property
    def name(self) -> str:
        """name of the test"""
    @property
    def units(self) -> FitUnits:
        """units of plain numbers"""
    @property
    def model(self) -> str | None:
        """fitted friction model: roughness, constant, drift, sinusoid or sinusoids"""
    @property
    def verdict(self) -> FitVerdict:
        """what the test comes to"""
    @property
    def answer(self) -> FitAnswerTable:
        """the rows of the screen"""
    @property
    def findings(self) -> FitFindingsTable:
        """all that was found out, the weightiest first"""
    @property
    def next(self) -> str:
        """the one step that would tell most; empty where there is none"""
    @property
    def category(self) -> str:
        """how clear the sawtooth is: clear, nominal or none"""
    @property
    def suspect(self) -> bool:
        """judgement.standing is suspect or untrusted, or no sliding explains the record"""
    @property
    def parameters(self) -> FitParameters:
        """fitted parameters of the friction model"""
    @property
    def friction_read(self) -> FitFrictionRead:
        """friction read off the curve point by point, at the bending stiffness of the fit: quantiles of mu in profile"""
    @property
    def residual_rms(self) -> float:
        """root mean square difference between the force and the mean of the fit run forward [N]"""
    @property
    def wave(self) -> FitWave | None:
        """likeliest wave of friction, claimed or not; null without one"""
    @property
    def explanations(self) -> FitExplanationsTable:
        """explanations that the answer averages over, the likeliest first"""
    @property
    def snaps(self) -> FitSnapsTable:
        """snaps of the mean of the fit, run forward"""
    @property
    def judgement(self) -> FitJudgement | None:
        """verdict on the test when all is weighed"""
    @property
    def surface(self) -> FitSurface | None:
        """surface that would explain how friction varies; null if friction does not vary"""
    @property
    def bending(self) -> FitBending:
        """how far the specimen was strained"""
    @property
    def imaged_length(self) -> FitImagedLength | None:
        """imaged lengths compared with those read off the force; null without any"""
    @property
    def slip_or_crack(self) -> FitSlipOrCrack | None:
        """what the rises between the drops say about slips and cracks; null if there are too few"""
    @property
    def drops(self) -> FitDropsTable:
        """drops of the force"""
    @property
    def slips(self) -> FitSlips:
        """drops that can be slips at the stated bending stiffness, read off at that of the fit"""
    @property
    def teeth(self) -> FitTeeth | None:
        """whether the specimen sticks or slides between the drops; null if that was not asked"""
    @property
    def suspects(self) -> FitSuspectsTable:
        """points that need implausibly high friction, at the stated bending stiffness"""
    @property
    def energy(self) -> FitEnergy | None:
        """where the work went, from contact to failure, computed from the measured points at the bending stiffness of the fit"""
    @property
    def replay(self) -> FitReplay | None:
        """the profile read off the record, run forward"""
    @property
    def cycles(self) -> FitCycles | None:
        """loading and unloading loops of a test that was unloaded; null otherwise"""
    @property
    def band(self) -> FitBand:
        """friction along the specimen, from the fit"""
    @property
    def small_deflection(self) -> FitSmallDeflection:
        """the straight part of the curve, beside the fit"""
    @property
    def measurement(self) -> FitMeasurement:
        """part of the file that is evaluated"""
    @property
    def preparation(self) -> FitPreparationTable:
        """steps from the file to the record"""
    @property
    def contact(self) -> FitContact:
        """point of first contact with the specimen"""
    @property
    def nominal_bending_stiffness(self) -> FitNominalBendingStiffness:
        """what was known about EI before the fit"""
    @property
    def draws(self) -> FitDraws:
        """profiles that --draws writes"""
    @property
    def noise(self) -> FitNoise:
        """noise of the force"""
    @property
    def profile(self) -> FitProfileTable:
        """friction along the specimen, read off the curve point by point at the bending stiffness of the fit"""
    @property
    def provenance(self) -> FitProvenance:
        """what the same version needs to give the same answer"""

class SimulationUnits(Answer):
    """units of plain numbers"""

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
    """path of the test, point by point"""

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
        """length of the specimen's axis between the contacts [m]"""
    @property
    def q(self) -> float:
        """mobilised friction [1]"""
    @property
    def motion(self) -> str:
        """how the specimen moves: stick, slip_in, slip_out, snap, crack, apart (the nose lifts off)"""
    @property
    def drawn_in(self) -> float:
        """length that has slid past the first contacts, over both supports [m]"""
    @property
    def imaged(self) -> float:
        """length of the axis between the verticals through the supports, as a camera sees it [m]"""
    @property
    def strain(self) -> float:
        """bending strain of the surface at midspan [1]"""
    @property
    def stress(self) -> float:
        """bending stress of the surface at midspan [Pa]"""
    @property
    def left(self) -> float:
        """length pulled in over the first support [m]"""
    @property
    def right(self) -> float:
        """length pulled in over the other support [m]"""
    @property
    def stage_work(self) -> float:
        """work of the stage [J]"""
    @property
    def bending(self) -> float:
        """energy stored in the bent specimen [J]"""
    @property
    def load_train(self) -> float:
        """energy stored in the load train [J]"""
    @property
    def friction(self) -> float:
        """heat of friction at the supports [J]"""
    @property
    def snaps(self) -> float:
        """energy set free by snaps beyond friction [J]"""
    @property
    def cracks(self) -> float:
        """energy set free by cracks [J]"""

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
    """snaps of the specimen"""

    @property
    def stage(self) -> float:
        """stage position, which stays the same [m]"""
    @property
    def deflection_before(self) -> float:
        """deflection before the jump [m]"""
    @property
    def deflection_after(self) -> float:
        """deflection after the jump [m]"""
    @property
    def force_before(self) -> float:
        """force before the jump [N]"""
    @property
    def force_after(self) -> float:
        """force after the jump [N]"""
    @property
    def length_before(self) -> float:
        """length between the supports before the snap: the span and what was pulled in [m]"""
    @property
    def length_after(self) -> float:
        """length between the supports after the snap: the span and what was pulled in [m]"""
    @property
    def friction(self) -> float:
        """heat of friction in the snap [J]"""
    @property
    def released(self) -> float:
        """energy that the snap sets free beyond friction [J]"""

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
    """stated cracks, where they opened"""

    @property
    def stage(self) -> float:
        """stage position, which stays the same [m]"""
    @property
    def deflection_before(self) -> float:
        """deflection before the jump [m]"""
    @property
    def deflection_after(self) -> float:
        """deflection after the jump [m]"""
    @property
    def force_before(self) -> float:
        """force before the jump [N]"""
    @property
    def force_after(self) -> float:
        """force after the jump [N]"""
    @property
    def left(self) -> float:
        """share of the initial bending stiffness that is left after the crack [1]"""
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
    """legs from turn to turn of the stage, with the change of each energy"""

    @property
    def direction(self) -> str:
        """direction of the leg: loading or unloading"""
    @property
    def from_(self) -> float:
        """stage position where the leg begins [m]"""
    @property
    def to(self) -> float:
        """stage position where the leg ends [m]"""
    @property
    def stage_work(self) -> float:
        """work of the stage [J]"""
    @property
    def bending(self) -> float:
        """energy stored in the bent specimen [J]"""
    @property
    def load_train(self) -> float:
        """energy stored in the load train [J]"""
    @property
    def friction(self) -> float:
        """heat of friction at the supports [J]"""
    @property
    def snaps(self) -> float:
        """energy set free by snaps beyond friction [J]"""
    @property
    def cracks(self) -> float:
        """energy set free by cracks [J]"""
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
        """energy stored in the bent specimen [J]"""
    @property
    def load_train(self) -> float:
        """energy stored in the load train [J]"""
    @property
    def friction(self) -> float:
        """heat of friction at the supports [J]"""
    @property
    def snaps(self) -> float:
        """energy set free by snaps beyond friction [J]"""
    @property
    def cracks(self) -> float:
        """energy set free by cracks [J]"""
    @property
    def work_of_fracture(self) -> float:
        """work on the specimen: area under force over deflection [J]"""
    @property
    def friction_share(self) -> float:
        """share of the work of fracture that went into friction and snaps [1]"""

class SimulationFields(Answer):
    """What a test would measure."""

    @property
    def status(self) -> str:
        """whether the path is complete: ok, or why it ends early: slipped_through, contact_lost"""
    @property
    def units(self) -> SimulationUnits:
        """units of plain numbers"""
    @property
    def path(self) -> SimulationPathTable:
        """path of the test, point by point"""
    @property
    def snaps(self) -> SimulationSnapsTable:
        """snaps of the specimen"""
    @property
    def cracks(self) -> SimulationCracksTable:
        """stated cracks, where they opened"""
    @property
    def wraps_nose_from(self) -> float:
        """stage position from which the specimen wraps the nose; null if it does not [m]"""
    @property
    def legs(self) -> SimulationLegsTable:
        """legs from turn to turn of the stage, with the change of each energy"""
    @property
    def energy(self) -> SimulationEnergy:
        """where the work went, from the start to the end"""

class ProfileUnits(Answer):
    """units of plain numbers"""

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
    """bending stiffness used"""

    @property
    def value(self) -> float:
        """EI [N m^2]"""
    @property
    def relative_error(self) -> float:
        """relative standard deviation of EI [1]"""
    @property
    def source(self) -> str:
        """where EI comes from: stated, stated_without_uncertainty, initial_slope or mirror_symmetry"""

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
        """length of the specimen's axis between the contacts [m]"""
    @property
    def drawn_in(self) -> float:
        """length pulled in (both supports) [m]"""
    @property
    def imaged(self) -> float:
        """length of the axis between the verticals through the supports, as a camera sees it [m]"""
    @property
    def mu(self) -> float:
        """mobilised friction: the coefficient of friction while the specimen slides [1]"""
    @property
    def mu_error(self) -> float:
        """standard error of mu [1]"""
    @property
    def mu_error_force(self) -> float:
        """part of mu_error from the noise of the force [1]"""
    @property
    def mu_error_bending_stiffness(self) -> float:
        """part of mu_error from EI, which moves all points together [1]"""
    @property
    def mu_error_contact(self) -> float:
        """part of mu_error from the contact point, which moves all points together [1]"""

class ProfileProfileTable(Table[ProfileProfile]):
    row: Any
    stage: Numbers
    deflection: Numbers
    force: Numbers
    length: Numbers
    drawn_in: Numbers
    imaged: Numbers
    mu: Numbers
    mu_error: Numbers
    mu_error_force: Numbers
    mu_error_bending_stiffness: Numbers
    mu_error_contact: Numbers

class ProfileFields(Answer):
    """Friction point by point."""

    @property
    def status(self) -> str:
        """whether friction was read off: ok, or nothing_explained"""
    @property
    def units(self) -> ProfileUnits:
        """units of plain numbers"""
    @property
    def bending_stiffness(self) -> ProfileBendingStiffness:
        """bending stiffness used"""
    @property
    def contact_offset(self) -> float:
        """displacement of the contact, subtracted from stage and deflection [m]"""
    @property
    def force_noise(self) -> float:
        """standard deviation of one force reading [N]"""
    @property
    def last_row(self) -> int:
        """last row of the file that is evaluated"""
    @property
    def profile(self) -> ProfileProfileTable:
        """friction along the specimen, point by point"""
    @property
    def unexplained(self) -> Numbers:
        """rows of the file that no friction explains [1]"""

class DesignPhases(Answer):
    """what the phase of the friction decides; null if it decides nothing"""

    @property
    def count(self) -> int:
        """number of phases of the waves of friction that were tried"""
    @property
    def snapping(self) -> int:
        """number of phases with which the specimen snaps"""
    @property
    def least_largest_drop(self) -> float:
        """smallest of the largest drops, one for each phase [N]"""
    @property
    def greatest_largest_drop(self) -> float:
        """greatest of the largest drops, one for each phase [N]"""
    @property
    def critical_stiffness(self) -> float:
        """stiffness at and above which the specimen snaps with none of the phases [N/m]"""

class DesignChanges(Answer):
    """single changes that reverse the answer"""

    @property
    def parameter(self) -> str:
        """parameter that changes, while the others stay"""
    @property
    def from_(self) -> float:
        """present value, in the unit of the parameter [1]"""
    @property
    def to(self) -> float:
        """changed value, in the unit of the parameter [1]"""
    @property
    def and_beyond(self) -> bool:
        """the changed answer holds however far beyond"""
    @property
    def largest_drop_share(self) -> float:
        """largest drop after the change, as a share of the greatest force [1]"""
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
    """parameters of the design, in their units; null if infinite"""

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
    """units of plain numbers"""

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
        """whether the design was computed: ok, slipped_through or breaks (the outcomes are those up to there), impossible or not_computable"""
    @property
    def stage_reached(self) -> float:
        """stage position that the loading reaches [m]"""
    @property
    def deflection_reached(self) -> float:
        """deflection at that stage position [m]"""
    @property
    def snaps(self) -> int | None:
        """number of snaps of the specimen, however small"""
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
        """number of drops that the record shows: falls of the force between readings, a run of them counting once"""
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
        """greatest bending strain of the surface at midspan; none without a section [1]"""
    @property
    def greatest_stress(self) -> float:
        """greatest bending stress of the surface at midspan; none without a section [Pa]"""
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
        """share of the work that goes into friction and snaps [1]"""
    @property
    def answer(self) -> str:
        """whether the test shows a sawtooth, in a sentence"""
    @property
    def critical_stiffness(self) -> float:
        """smallest stiffness at and above which this loading meets no snap; null if it snaps on every rig, 0 if on none [N/m]"""
    @property
    def pin_limit(self) -> float:
        """greatest friction that can act, at which the rollers turn on their pins; null for other supports [1]"""
    @property
    def snaps_whatever_the_stiffness(self) -> bool:
        """the specimen snaps even if the deflection itself is controlled"""
    @property
    def phases(self) -> DesignPhases | None:
        """what the phase of the friction decides; null if it decides nothing"""
    @property
    def changes(self) -> DesignChangesTable:
        """single changes that reverse the answer"""
    @property
    def parameters(self) -> DesignParameters:
        """parameters of the design, in their units; null if infinite"""
    @property
    def units(self) -> DesignUnits:
        """units of plain numbers"""

class CampaignTestsParametersMu0(Estimate):
    """mean friction over the specimen seen"""

    @property
    def bound(self) -> bool:
        """mu0 cannot be distinguished from 0, and the upper end of its interval is a limit"""

class CampaignTestsParameters(Answer):
    """fitted parameters; null where the fit has none"""

    @property
    def mu0(self) -> CampaignTestsParametersMu0:
        """mean friction over the specimen seen [1]"""
    @property
    def roughness(self) -> Estimate | None:
        """standard deviation of friction about its mean [1]"""
    @property
    def correlation_length(self) -> Estimate | None:
        """correlation length of friction along the specimen [m]"""
    @property
    def amplitude(self) -> Estimate | None:
        """amplitude of the likeliest wave of friction, relative to mu0 [1]"""
    @property
    def wavelength(self) -> Estimate | None:
        """wavelength of the likeliest wave of friction, along the specimen [m]"""
    @property
    def surface_height(self) -> Estimate | None:
        """amplitude of the surface wave that would explain the wave of friction [m]"""
    @property
    def surface_slope(self) -> Estimate | None:
        """rms slope of the surface that would explain the friction [1]"""
    @property
    def phase(self) -> Estimate | None:
        """phase of the likeliest wave of friction at the length 0 [rad]"""
    @property
    def bending_stiffness(self) -> Estimate:
        """EI of the fit [N m^2]"""

class CampaignTestsWave(Answer):
    """likeliest wave of friction, and whether it is claimed"""

    @property
    def claimed(self) -> bool:
        """the evidence supports the wave; otherwise it is only indicative"""
    @property
    def log_evidence(self) -> float:
        """ln of the ratio of the evidence with and without a wave [1]"""

class CampaignTestsFrictionRead(Answer):
    """friction read off the curve point by point, without a friction model"""

    @property
    def median(self) -> float:
        """friction below which half of the points lie [1]"""
    @property
    def low80(self) -> float:
        """friction below which a tenth of the points lie [1]"""
    @property
    def high80(self) -> float:
        """friction above which a tenth of the points lie [1]"""

class CampaignTests(Answer):
    """tests with an answer, in the order of the plan"""

    @property
    def name(self) -> str:
        """name of the test"""
    @property
    def status(self) -> str:
        """whether the test has an answer: a status of fit, or failed"""
    @property
    def verdict(self) -> str:
        """SLIP, UNDECIDED, CRACK, NO DROPS, CHECK INPUT or NO ANSWER"""
    @property
    def category(self) -> str | None:
        """how clear the sawtooth is: clear, nominal or none"""
    @property
    def suspect(self) -> bool | None:
        """standing is suspect or untrusted"""
    @property
    def standing(self) -> str | None:
        """how far the answer can be trusted: sound, doubtful, suspect or untrusted; the remarks say why"""
    @property
    def drops_verdict(self) -> str | None:
        """whether cracks alone can make the drops: not_by_cracks_alone, cracks or cannot_be_told; null without drops"""
    @property
    def model(self) -> str | None:
        """fitted friction model"""
    @property
    def parameters(self) -> CampaignTestsParameters | None:
        """fitted parameters; null where the fit has none"""
    @property
    def wave(self) -> CampaignTestsWave | None:
        """likeliest wave of friction, and whether it is claimed"""
    @property
    def friction_read(self) -> CampaignTestsFrictionRead | None:
        """friction read off the curve point by point, without a friction model"""
    @property
    def failed_checks(self) -> tuple[str, ...] | None:
        """failed checks: residuals, drops, whiteness, nesting, friction, stability, stiffness"""
    @property
    def residual_rms(self) -> float:
        """root mean square difference between the measured force and the mean of the fit run forward [N]"""
    @property
    def drops(self) -> int | None:
        """number of drops of the force beyond its noise"""
    @property
    def spacing(self) -> float:
        """length of specimen from one slip to the next, median [m]"""
    @property
    def work_of_fracture(self) -> float:
        """work on the specimen [J]"""
    @property
    def friction_share(self) -> float:
        """share of the work that went into friction and snaps; null if the test is not trusted or gives only a limit [1]"""
    @property
    def reason(self) -> str | None:
        """reason why the status is not ok"""
    @property
    def remarks(self) -> tuple[str, ...]:
        """remarks on the test"""
    @property
    def file(self) -> str:
        """file that describes the test"""

class CampaignTestsTable(Table[CampaignTests]):
    name: Objects
    status: Objects
    verdict: Objects
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
    spacing: Numbers
    work_of_fracture: Numbers
    friction_share: Numbers
    reason: Objects
    remarks: Objects
    file: Objects

class CampaignCategoriesMu0(Answer):
    """mean friction, without tests that give only a limit"""

    @property
    def mean(self) -> float:
        """mean over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest value [1]"""
    @property
    def max(self) -> float:
        """largest value [1]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesMu0Limit(Answer):
    """upper limits of mean friction, of the tests that give only a limit"""

    @property
    def mean(self) -> float:
        """mean over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest value [1]"""
    @property
    def max(self) -> float:
        """largest value [1]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesAmplitude(Answer):
    """amplitude of the wave of friction, relative to mu0"""

    @property
    def mean(self) -> float:
        """mean over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest value [1]"""
    @property
    def max(self) -> float:
        """largest value [1]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesWavelength(Answer):
    """wavelength of the wave of friction, along the specimen"""

    @property
    def mean(self) -> float:
        """mean over the tests [m]"""
    @property
    def min(self) -> float:
        """smallest value [m]"""
    @property
    def max(self) -> float:
        """largest value [m]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesSurfaceHeight(Answer):
    """amplitude of the surface wave that would explain the wave of friction"""

    @property
    def mean(self) -> float:
        """mean over the tests [m]"""
    @property
    def min(self) -> float:
        """smallest value [m]"""
    @property
    def max(self) -> float:
        """largest value [m]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesSurfaceSlope(Answer):
    """rms slope of the surface that would explain the friction"""

    @property
    def mean(self) -> float:
        """mean over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest value [1]"""
    @property
    def max(self) -> float:
        """largest value [1]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesWithSuspectsMu0(Answer):
    """mean friction, without tests that give only a limit"""

    @property
    def mean(self) -> float:
        """mean over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest value [1]"""
    @property
    def max(self) -> float:
        """largest value [1]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesWithSuspectsMu0Limit(Answer):
    """upper limits of mean friction, of the tests that give only a limit"""

    @property
    def mean(self) -> float:
        """mean over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest value [1]"""
    @property
    def max(self) -> float:
        """largest value [1]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesWithSuspectsAmplitude(Answer):
    """amplitude of the wave of friction, relative to mu0"""

    @property
    def mean(self) -> float:
        """mean over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest value [1]"""
    @property
    def max(self) -> float:
        """largest value [1]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesWithSuspectsWavelength(Answer):
    """wavelength of the wave of friction, along the specimen"""

    @property
    def mean(self) -> float:
        """mean over the tests [m]"""
    @property
    def min(self) -> float:
        """smallest value [m]"""
    @property
    def max(self) -> float:
        """largest value [m]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesWithSuspectsSurfaceHeight(Answer):
    """amplitude of the surface wave that would explain the wave of friction"""

    @property
    def mean(self) -> float:
        """mean over the tests [m]"""
    @property
    def min(self) -> float:
        """smallest value [m]"""
    @property
    def max(self) -> float:
        """largest value [m]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesWithSuspectsSurfaceSlope(Answer):
    """rms slope of the surface that would explain the friction"""

    @property
    def mean(self) -> float:
        """mean over the tests [1]"""
    @property
    def min(self) -> float:
        """smallest value [1]"""
    @property
    def max(self) -> float:
        """largest value [1]"""
    @property
    def n(self) -> int:
        """number of tests"""

class CampaignCategoriesWithSuspects(Answer):
    """the same, including suspect tests"""

    @property
    def tests(self) -> int:
        """number of tests in the category"""
    @property
    def mu0(self) -> CampaignCategoriesWithSuspectsMu0:
        """mean friction, without tests that give only a limit"""
    @property
    def mu0_limit(self) -> CampaignCategoriesWithSuspectsMu0Limit:
        """upper limits of mean friction, of the tests that give only a limit"""
    @property
    def amplitude(self) -> CampaignCategoriesWithSuspectsAmplitude:
        """amplitude of the wave of friction, relative to mu0"""
    @property
    def wavelength(self) -> CampaignCategoriesWithSuspectsWavelength:
        """wavelength of the wave of friction, along the specimen"""
    @property
    def waves_claimed(self) -> int:
        """number of tests that claim a wave of friction"""
    @property
    def surface_height(self) -> CampaignCategoriesWithSuspectsSurfaceHeight:
        """amplitude of the surface wave that would explain the wave of friction"""
    @property
    def surface_slope(self) -> CampaignCategoriesWithSuspectsSurfaceSlope:
        """rms slope of the surface that would explain the friction"""

class CampaignCategoriesBetweenSpecimensSpread(Estimate):
    """spread between specimens"""

    @property
    def bound(self) -> bool:
        """the specimens cannot be distinguished from each other"""

class CampaignCategoriesBetweenSpecimensSpecimens(Answer):
    """value of each specimen in the light of the others"""

    @property
    def test(self) -> str:
        """name of the test"""
    @property
    def value(self) -> float:
        """value of the parameter, in the unit of typical [1]"""
    @property
    def standard_error(self) -> float:
        """standard error of value [1]"""

class CampaignCategoriesBetweenSpecimensSpecimensTable(Table[CampaignCategoriesBetweenSpecimensSpecimens]):
    test: Objects
    value: Numbers
    standard_error: Numbers

class CampaignCategoriesBetweenSpecimens(Answer):
    """typical value and spread between specimens, by parameter"""

    @property
    def tests(self) -> int:
        """number of tests whose records determine the parameter"""
    @property
    def typical(self) -> Estimate:
        """typical specimen: the mean for mu0, the median for other parameters [1]"""
    @property
    def differ_by(self) -> str:
        """meaning of spread: a standard deviation, or a factor in either direction"""
    @property
    def spread(self) -> CampaignCategoriesBetweenSpecimensSpread:
        """spread between specimens [1]"""
    @property
    def specimens(self) -> CampaignCategoriesBetweenSpecimensSpecimensTable:
        """value of each specimen in the light of the others"""

class CampaignCategories(Answer):
    """categories clear, nominal, none and all, without suspect tests"""

    @property
    def tests(self) -> int:
        """number of tests in the category"""
    @property
    def mu0(self) -> CampaignCategoriesMu0:
        """mean friction, without tests that give only a limit"""
    @property
    def mu0_limit(self) -> CampaignCategoriesMu0Limit:
        """upper limits of mean friction, of the tests that give only a limit"""
    @property
    def amplitude(self) -> CampaignCategoriesAmplitude:
        """amplitude of the wave of friction, relative to mu0"""
    @property
    def wavelength(self) -> CampaignCategoriesWavelength:
        """wavelength of the wave of friction, along the specimen"""
    @property
    def waves_claimed(self) -> int:
        """number of tests that claim a wave of friction"""
    @property
    def surface_height(self) -> CampaignCategoriesSurfaceHeight:
        """amplitude of the surface wave that would explain the wave of friction"""
    @property
    def surface_slope(self) -> CampaignCategoriesSurfaceSlope:
        """rms slope of the surface that would explain the friction"""
    @property
    def with_suspects(self) -> CampaignCategoriesWithSuspects:
        """the same, including suspect tests"""
    @property
    def between_specimens(self) -> dict[str, CampaignCategoriesBetweenSpecimens]:
        """typical value and spread between specimens, by parameter"""

class CampaignFailures(Answer):
    """tests without an answer"""

    @property
    def name(self) -> str:
        """name of the test"""
    @property
    def status(self) -> str:
        """whether the test has an answer: a status of fit, or failed"""
    @property
    def verdict(self) -> str:
        """SLIP, UNDECIDED, CRACK, NO DROPS, CHECK INPUT or NO ANSWER"""
    @property
    def reason(self) -> str:
        """reason why there is no answer"""
    @property
    def file(self) -> str:
        """file that describes the test"""

class CampaignFailuresTable(Table[CampaignFailures]):
    name: Objects
    status: Objects
    verdict: Objects
    reason: Objects
    file: Objects

class CampaignShared(Answer):
    """parameters that tests share"""

    @property
    def name(self) -> str:
        """name of the parameter"""
    @property
    def unit(self) -> str:
        """unit of the estimate"""
    @property
    def value(self) -> float:
        """value of the shared parameter [1]"""
    @property
    def standard_error(self) -> float:
        """standard error of value [1]"""
    @property
    def interval95(self) -> Numbers:
        """95 % interval of value [1]"""
    @property
    def tests(self) -> int:
        """number of tests whose records determine the parameter"""
    @property
    def chi_squared(self) -> float:
        """chi-squared of the tests about the value, with one degree of freedom less than tests [1]"""
    @property
    def agreement(self) -> float:
        """probability that tests that share the value differ at least as much [1]"""

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
    """units of plain numbers"""

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
        """tests with an answer, in the order of the plan"""
    @property
    def categories(self) -> dict[str, CampaignCategories]:
        """categories clear, nominal, none and all, without suspect tests"""
    @property
    def failures(self) -> CampaignFailuresTable:
        """tests without an answer"""
    @property
    def shared(self) -> CampaignSharedTable:
        """parameters that tests share"""
    @property
    def units(self) -> CampaignUnits:
        """units of plain numbers"""

class EquilibriumUnits(Answer):
    """units of plain numbers"""

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
    """curve of loading, where friction is fully mobilised"""

    @property
    def length(self) -> float:
        """length of the specimen's axis between the contacts [m]"""
    @property
    def mu(self) -> float:
        """friction [1]"""
    @property
    def deflection(self) -> float:
        """deflection at midspan [m]"""
    @property
    def force(self) -> float:
        """force at midspan [N]"""
    @property
    def drawn_in(self) -> float:
        """length that has slid past the first contacts, over both supports [m]"""

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
        """whether the curve is complete: ok, or branch_ended, where the force has fallen to zero"""
    @property
    def units(self) -> EquilibriumUnits:
        """units of plain numbers"""
    @property
    def curve(self) -> EquilibriumCurveTable:
        """curve of loading, where friction is fully mobilised"""

class EquilibriumRegionUnits(Answer):
    """units of plain numbers"""

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
        """length of the specimen's axis between the contacts [m]"""
    @property
    def q(self) -> float:
        """mobilised friction [1]"""
    @property
    def deflection(self) -> float:
        """deflection at midspan [m]"""
    @property
    def force(self) -> float:
        """force at midspan [N]"""
    @property
    def drawn_in(self) -> float:
        """length that has slid past the first contacts, over both supports [m]"""

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
        """whether the curve is complete: ok, or branch_ended, where the force has fallen to zero"""
    @property
    def units(self) -> EquilibriumRegionUnits:
        """units of plain numbers"""
    @property
    def region(self) -> EquilibriumRegionRegionTable:
        """all equilibria, with --region"""

class ModulusChord(Answer):
    """chord of ISO 178; null if the record does not cover both strains"""

    @property
    def strain(self) -> Numbers:
        """flexural strains between which the chord is drawn [1]"""
    @property
    def deflection(self) -> Numbers:
        """deflections at the ends of the chord, from the origin [m]"""
    @property
    def stiffness(self) -> Estimate:
        """force over deflection between the ends of the chord [N/m]"""
    @property
    def modulus(self) -> Estimate | None:
        """flexural modulus of the chord, as defined by ISO 178 [Pa]"""

class ModulusWindow(Answer):
    """straight part of the curve"""

    @property
    def from_(self) -> float:
        """beginning of the straight part, as a share of of_force [1]"""
    @property
    def up_to(self) -> float:
        """end of the straight part, as a share of of_force [1]"""
    @property
    def of_force(self) -> float:
        """greatest force reached at a small deflection [N]"""
    @property
    def rows(self) -> Numbers:
        """first and last row of the straight part in the file [1]"""

class ModulusPreparation(Answer):
    """steps from the file to the record"""

    @property
    def step(self) -> str:
        """name of the step: columns, metadata, first, repeated, held, interpolated, sign, thinning, zero, compliance, end, turn, stage or contact"""
    @property
    def changed(self) -> bool:
        """numbers differ from those in the file, or rows are left out"""
    @property
    def done(self) -> str:
        """what was done, in words"""
    @property
    def value(self) -> float:
        """value that was subtracted, applied or found [1]"""
    @property
    def uncertainty(self) -> float:
        """standard deviation of value, if it is known [1]"""
    @property
    def unit(self) -> str | None:
        """unit of value and uncertainty"""
    @property
    def rows(self) -> Numbers | None:
        """first and last row of the file that the step concerns; null for all [1]"""
    @property
    def key(self) -> str | None:
        """what to write into the case to have the step done otherwise"""
    @property
    def flag(self) -> str | None:
        """flag of the command line that has the step done otherwise"""

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
        """whether there are numbers: ok, or no_straight_part"""
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
        """chord of ISO 178; null if the record does not cover both strains"""
    @property
    def window(self) -> ModulusWindow | None:
        """straight part of the curve"""
    @property
    def origin(self) -> Quantity | None:
        """deflection at which the straight part would meet zero force [m]"""
    @property
    def greatest_force(self) -> Quantity | None:
        """greatest force [N]"""
    @property
    def deflection(self) -> Quantity | None:
        """deflection at the greatest force, from the origin [m]"""
    @property
    def stress(self) -> Quantity | None:
        """flexural stress at the greatest force, F L depth/(8 I) [Pa]"""
    @property
    def strain(self) -> Quantity | None:
        """flexural strain at the greatest force, 6 δ depth/L² [1]"""
    @property
    def deflection_large(self) -> bool | None:
        """the deflection exceeds a tenth of the span, so stress and strain of the standards do not hold"""
    @property
    def supports_share(self) -> float:
        """share that rollers and thickness, which are neglected, add to the stiffness between the deflections of chord or straight part, without
        friction [1]"""
    @property
    def modulus_less_supports(self) -> Estimate | None:
        """modulus of the chord, or else of the straight part, without that share [Pa]"""
    @property
    def shear_share(self) -> float:
        """share that shear, which is neglected, adds to a small deflection [1]"""
    @property
    def preparation(self) -> ModulusPreparationTable:
        """steps from the file to the record"""

class SurfaceUnits(Answer):
    """units of plain numbers"""

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
    """trace as it was read"""

    @property
    def name(self) -> str:
        """name of the file, as it was given"""
    @property
    def position(self) -> str | None:
        """column of the positions; null if their distance was stated"""
    @property
    def height(self) -> str:
        """column of the heights"""
    @property
    def heights(self) -> int:
        """number of heights"""
    @property
    def step(self) -> float:
        """distance between heights [m]"""
    @property
    def field(self) -> float:
        """width of the trace [m]"""
    @property
    def unevenness(self) -> float:
        """greatest relative departure of a distance between heights from the mean [1]"""
    @property
    def interpolated(self) -> bool:
        """heights were interpolated, as their distances differ by more than 1 %"""
    @property
    def notes(self) -> tuple[str, ...]:
        """what was decided about the file"""

class SurfaceTreatment(Answer):
    """treatment of the heights"""

    @property
    def level(self) -> int:
        """degree of the polynomial that was subtracted"""
    @property
    def cutoff(self) -> float:
        """cutoff of the Gaussian filter; null without one [m]"""
    @property
    def edge_radius(self) -> float:
        """radius of the edge that is drawn over the surface [m]"""
    @property
    def tapers(self) -> int:
        """number of tapers of the spectrum"""

class SurfaceWaves(Answer):
    """waves that stand out from the spectrum, the highest first"""

    @property
    def wavelength(self) -> Estimate:
        """wavelength along the trace [m]"""
    @property
    def amplitude(self) -> Estimate:
        """amplitude of the height, half of crest to trough [m]"""
    @property
    def slope_amplitude(self) -> float:
        """amplitude of the slope, 2π amplitude/wavelength [1]"""
    @property
    def coherent(self) -> bool:
        """the wave keeps one phase along the whole trace"""
    @property
    def phase(self) -> float:
        """phase of a coherent wave at position 0; null for others [rad]"""
    @property
    def p_value(self) -> float:
        """probability that a surface without waves shows a wave like this one anywhere [1]"""

class SurfaceWavesTable(Table[SurfaceWaves]):
    wavelength: Objects
    amplitude: Objects
    slope_amplitude: Numbers
    coherent: Objects
    phase: Numbers
    p_value: Numbers

class SurfaceResolution(Answer):
    """resolution at the wavelengths asked for, those found, or a tenth of the field"""

    @property
    def wavelength(self) -> float:
        """wavelength in question [m]"""
    @property
    def heights_a_wave(self) -> float:
        """heights per wave; at least two are needed [1]"""
    @property
    def waves_in_field(self) -> float:
        """waves in the field; the paper asks for ten [1]"""
    @property
    def least_amplitude_by_pixels(self) -> float:
        """smallest amplitude that shows by the paper's rule, ten pixels from crest to trough; null if the pixel is unknown [m]"""
    @property
    def least_amplitude_by_spectrum(self) -> float:
        """smallest amplitude of a coherent wave that stands out from noise and roughness in 95 of 100 such traces [m]"""
    @property
    def pixel_wanted(self) -> float:
        """pixel that the paper's rule asks for, for a wave of the amplitude asked for or found [m]"""

class SurfaceResolutionTable(Table[SurfaceResolution]):
    wavelength: Numbers
    heights_a_wave: Numbers
    waves_in_field: Numbers
    least_amplitude_by_pixels: Numbers
    least_amplitude_by_spectrum: Numbers
    pixel_wanted: Numbers

class SurfaceFriction(Answer):
    """friction that the slopes predict; null if no friction of the flat surface is stated"""

    @property
    def base(self) -> float:
        """friction of the flat surface, as stated [1]"""
    @property
    def mean(self) -> float:
        """mean of the friction that the slopes predict [1]"""
    @property
    def deviation(self) -> float:
        """standard deviation of the friction that the slopes predict [1]"""
    @property
    def low95(self) -> float:
        """friction below which a fortieth of the trace lies [1]"""
    @property
    def high95(self) -> float:
        """friction above which a fortieth of the trace lies [1]"""

class SurfaceFields(Answer):
    """What a height profile says of its surface."""

    @property
    def status(self) -> str:
        """whether the trace shows a surface: ok, or noise"""
    @property
    def units(self) -> SurfaceUnits:
        """units of plain numbers"""
    @property
    def trace(self) -> SurfaceTrace:
        """trace as it was read"""
    @property
    def treatment(self) -> SurfaceTreatment:
        """treatment of the heights"""
    @property
    def rms_height_of_trace(self) -> float:
        """rms height of the levelled trace, including noise [m]"""
    @property
    def shortest(self) -> float:
        """shortest wavelength in rms_height and rms_slope [m]"""
    @property
    def longest(self) -> float:
        """longest wavelength in rms_height and rms_slope [m]"""
    @property
    def shortest_is(self) -> str:
        """where shortest comes from: noise (where it equals the surface), five_steps or stated"""
    @property
    def rms_height(self) -> Estimate | None:
        """rms height of the surface between these wavelengths, without noise [m]"""
    @property
    def rms_slope(self) -> Estimate | None:
        """rms slope of the surface between these wavelengths, without noise [1]"""
    @property
    def rms_slope_of_edge(self) -> float:
        """rms slope of the path of the edge, from height to height; null for a sharp edge [1]"""
    @property
    def correlation_length(self) -> Estimate | None:
        """distance at which the correlation has fallen to 1/e; null beyond a tenth of the field [m]"""
    @property
    def noise(self) -> float:
        """standard deviation of the white noise of a height [m]"""
    @property
    def noise_is(self) -> str:
        """where noise comes from: stated, found or not_found"""
    @property
    def waves(self) -> SurfaceWavesTable:
        """waves that stand out from the spectrum, the highest first"""
    @property
    def pixel(self) -> float:
        """smallest difference between heights; null if heights are as fine as their noise [m]"""
    @property
    def pixel_is(self) -> str | None:
        """where pixel comes from: stated, or heights (all are multiples of it); null without one"""
    @property
    def resolution(self) -> SurfaceResolutionTable:
        """resolution at the wavelengths asked for, those found, or a tenth of the field"""
    @property
    def friction(self) -> SurfaceFriction | None:
        """friction that the slopes predict; null if no friction of the flat surface is stated"""

class SweepCounts(Answer):
    """number of designs by status; null if they were not counted now"""

    @property
    def ok(self) -> int:
        """number of designs with this status"""
    @property
    def slipped_through(self) -> int:
        """number of designs with this status"""
    @property
    def impossible(self) -> int:
        """number of designs with this status"""
    @property
    def not_computable(self) -> int:
        """number of designs with this status"""
    @property
    def breaks(self) -> int:
        """number of designs with this status"""

class SweepFaults(Answer):
    """parts that are missing or damaged"""

    @property
    def file(self) -> str:
        """file of the part that is missing or damaged"""
    @property
    def rows(self) -> Numbers:
        """first and last row of the sweep in the part [1]"""
    @property
    def state(self) -> str:
        """state of the part: missing or damaged"""

class SweepFaultsTable(Table[SweepFaults]):
    file: Objects
    rows: Objects
    state: Objects

class SweepFields(Answer):
    """What came of a sweep."""

    @property
    def status(self) -> str:
        """whether the sweep is complete: done, or incomplete (parts are missing or damaged)"""
    @property
    def file(self) -> str | None:
        """file that holds the sweep; null for a shard"""
    @property
    def rows(self) -> int | None:
        """number of designs of the sweep; null if unknown"""
    @property
    def counts(self) -> SweepCounts | None:
        """number of designs by status; null if they were not counted now"""
    @property
    def faults(self) -> SweepFaultsTable:
        """parts that are missing or damaged"""
    @property
    def parts(self) -> str | None:
        """folder of the parts of a shard"""
    @property
    def shard(self) -> Numbers | None:
        """index of the shard and number of shards [1]"""
    @property
    def rows_found(self) -> int | None:
        """number of designs of the shard that were already there"""
    @property
    def rows_computed(self) -> int | None:
        """number of designs of the shard computed now"""

class ExportColumns(Answer):
    """columns of the chosen specimen"""

    @property
    def number(self) -> int:
        """number of the column in the file, from 1"""
    @property
    def name(self) -> str:
        """name of the column, as in the file"""
    @property
    def unit(self) -> str | None:
        """unit of the column, as in the file; null if there is none"""
    @property
    def role(self) -> str:
        """role of the column: time, displacement, crosshead, deflection, force or other"""
    @property
    def first(self) -> Any:
        """content of the first row"""
    @property
    def last(self) -> Any:
        """content of the last row"""

class ExportColumnsTable(Table[ExportColumns]):
    number: Any
    name: Objects
    unit: Objects
    role: Objects
    first: Objects
    last: Objects

class ExportSpecimensColumns(Answer):
    """columns of the specimen"""

    @property
    def number(self) -> int:
        """number of the column in the file, from 1"""
    @property
    def name(self) -> str:
        """name of the column, as in the file"""
    @property
    def unit(self) -> str | None:
        """unit of the column, as in the file; null if there is none"""
    @property
    def role(self) -> str:
        """role of the column: time, displacement, crosshead, deflection, force or other"""
    @property
    def first(self) -> Any:
        """content of the first row"""
    @property
    def last(self) -> Any:
        """content of the last row"""

class ExportSpecimensColumnsTable(Table[ExportSpecimensColumns]):
    number: Any
    name: Objects
    unit: Objects
    role: Objects
    first: Objects
    last: Objects

class ExportSpecimens(Answer):
    """specimens in the file"""

    @property
    def name(self) -> str:
        """name of the specimen; empty if the file names none"""
    @property
    def columns(self) -> ExportSpecimensColumnsTable:
        """columns of the specimen"""
    @property
    def rows(self) -> int:
        """number of rows of the specimen"""
    @property
    def first_line(self) -> int:
        """line of the file with the first row"""
    @property
    def last_line(self) -> int:
        """line of the file with the last row"""
    @property
    def metadata(self) -> dict[str, str]:
        """what the file says about this specimen, under the file's own names"""

class ExportSpecimensTable(Table[ExportSpecimens]):
    name: Objects
    columns: Objects
    rows: Any
    first_line: Any
    last_line: Any
    metadata: Objects

class ExportTest(Answer):
    """metadata that were understood; null if not stated"""

    @property
    def span(self) -> float:
        """support span [m]"""
    @property
    def diameter(self) -> float:
        """diameter of the specimen [m]"""
    @property
    def width(self) -> float:
        """width of the specimen [m]"""
    @property
    def thickness(self) -> float:
        """thickness of the specimen [m]"""
    @property
    def rate(self) -> float:
        """speed of the crosshead, in m/s [1]"""

class ExportFields(Answer):
    """What an export holds."""

    @property
    def format(self) -> str:
        """format of the file: Instron Bluehill, …, or table"""
    @property
    def sheet(self) -> str | None:
        """sheet of the workbook (.xlsx) that was read; null for a text file"""
    @property
    def sheets(self) -> tuple[str, ...]:
        """sheets of the workbook, in their order"""
    @property
    def encoding(self) -> str:
        """encoding of the text"""
    @property
    def byte_order_mark(self) -> bool:
        """the file begins with a byte order mark"""
    @property
    def delimiter(self) -> str | None:
        """separator between columns"""
    @property
    def decimal(self) -> str | None:
        """decimal mark"""
    @property
    def thousands(self) -> str | None:
        """mark between thousands; null without one"""
    @property
    def quoted(self) -> bool:
        """cells stand in quotes"""
    @property
    def columns(self) -> ExportColumnsTable:
        """columns of the chosen specimen"""
    @property
    def rows(self) -> int:
        """number of rows of the chosen specimen"""
    @property
    def specimens(self) -> ExportSpecimensTable:
        """specimens in the file"""
    @property
    def metadata(self) -> dict[str, str]:
        """what the file says about all specimens, under its own names"""
    @property
    def test(self) -> ExportTest:
        """metadata that were understood; null if not stated"""
    @property
    def notes(self) -> tuple[str, ...]:
        """decisions about the file, and what was left out"""
    @property
    def asks(self) -> tuple[str, ...]:
        """questions that the file leaves open and an evaluation needs answered, each with its flag"""
    @property
    def repeat_with(self) -> str:
        """flags that make the same decisions again"""
