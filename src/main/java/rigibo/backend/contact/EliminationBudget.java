package rigibo.backend.contact;

import rigibo.backend.contact.row.Effort;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.setup.Accuracy;

/** The work that eliminating an island is worth, in multiplications; from EXACT on any work. */
final class EliminationBudget {

    /**
     * Work of passes per contact and substep, in multiplications: about six solutions of 60 each.
     */
    private static final double WORK_OF_PASSES = 6 * 60;

    /** Worth beside the work of passes, for equal masses and e = 0, where passes converge fast. */
    private static final double WORTH = 0.25;

    /**
     * Counterpart of {@link #WORTH} for a single body on immovable ones, which has three unknowns,
     * and for islands that a driven body presses: no load can stop it.
     */
    private static final double WORTH_ALONE = 8;

    /** Largest worth by elasticity: elastic bodies do not lose the error that passes leave. */
    private static final double MOST_BY_ELASTICITY = 100;

    /**
     * Largest worth by the ratio of masses: a bullet would be through a box of a smaller mass
     * before passes converge.
     */
    private static final double MOST_BY_MASS = 300;

    /**
     * Counterpart of {@link #WORTH} for a calm island, which rests once it is solved and then costs
     * nothing.
     */
    private static final double WORTH_IF_CALM = 12;

    /** Speed up to which contacts count as steady, as a share of a free body's gain in a step. */
    private static final double STEADY = 1e-3;

    /**
     * Least budget of an island in a substep of the game's length or shorter: some microseconds. It
     * grows with the root of the length, so that {@code DRAFT}, whose passes do not hold a column
     * of eight boxes that rocks, eliminates it.
     */
    private static final double LEAST = 2_500;

    /** Least budget of the impacts of an island in a step. */
    private static final double LEAST_OF_IMPACTS = 1e5;

    private final Motions motions;
    private final PackedContacts contacts;

    /** Work of passes per contact and substep; infinite where work has no limit. */
    private final double ofPasses;

    private final double ofCalmContact;
    private final double least;

    EliminationBudget(Motions motions, PackedContacts contacts, Accuracy accuracy) {
        this.motions = motions;
        this.contacts = contacts;
        double coarser = Math.min(1, Effort.timesGame(accuracy));
        least = LEAST / Math.sqrt(coarser);
        ofPasses = Effort.isExact(accuracy) ? Double.POSITIVE_INFINITY : WORK_OF_PASSES;
        ofCalmContact = WORTH_IF_CALM * coarser * ofPasses;
    }

    /** Budget of the packed island in a substep; a free body gains {@code gained} m/s in a step. */
    double ofSubstep(boolean isCalm, double gained) {
        double moving = ofPasses * timesOfPasses();
        boolean isSteady = isCalm || areContactsSteady(STEADY * gained);
        double ofContact = isSteady ? Math.max(ofCalmContact, moving) : moving;
        return Math.max(least, ofContact * contacts.count);
    }

    /** Budget of the impacts of a number of kicks. */
    double ofImpacts(int kicks) {
        return Math.max(LEAST_OF_IMPACTS, ofPasses * kicks * contacts.count);
    }

    /** Budget by the ratio of masses, as a multiple of the work of passes. */
    static double timesByMass(Motions motions) {
        return Math.min(MOST_BY_MASS, WORTH * motions.massRatio());
    }

    /** Budget of a moving island, as a multiple of the work of passes. */
    private double timesOfPasses() {
        double elasticity = contacts.highestElasticity();
        double lost = 1 - elasticity * elasticity;
        double byElasticity = WORTH / Math.max(lost, 1 / MOST_BY_ELASTICITY);
        double moving = Math.max(byElasticity, timesByMass(motions));
        boolean isAlone = motions.count == 2 || motions.isAnyDriven;
        return isAlone ? Math.max(WORTH_ALONE, moving) : moving;
    }

    /**
     * Whether every loaded contact persists and no other one closes: no point of theirs parts or
     * closes faster than {@code most} m/s. Then the same rows are loaded again in the next substep,
     * however fast bodies roll and slide.
     */
    private boolean areContactsSteady(double most) {
        for (int row = 0; row < contacts.count; row++) {
            for (int point = 0; point < contacts.points[row]; point++) {
                double parts = motions.parting(contacts, row, point);
                if (parts < -most || parts > most && contacts.carries(row, point)) {
                    return false;
                }
            }
        }
        return true;
    }
}
