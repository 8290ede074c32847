package rigibo.backend.contact;

import rigibo.backend.contact.bounce.IslandImpacts;
import rigibo.backend.contact.row.BentRows;
import rigibo.backend.contact.row.CurvedRows;
import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.RunningRows;
import rigibo.backend.contact.row.SharedRows;
import rigibo.backend.contact.row.Straightness;
import rigibo.backend.contact.row.Strays;
import rigibo.backend.contact.row.TurningRows;
import rigibo.backend.contact.solve.FrictionSolver;
import rigibo.backend.contact.solve.NoRubbing;
import rigibo.backend.contact.solve.RollingSolver;
import rigibo.backend.contact.solve.Rubbing;
import rigibo.backend.effect.Effects;
import rigibo.backend.effect.Friction;
import rigibo.backend.effect.Restitution;
import rigibo.backend.effect.RollingResistance;
import rigibo.backend.effect.Rotation;
import rigibo.backend.effect.SurfaceSpeed;
import rigibo.backend.storage.DataStorage;

/**
 * The parts of contact solving that depend on the declared effects. A part whose effect is not
 * declared is null, which is tested once per substep rather than once per contact, and its classes
 * are not even loaded.
 */
final class DeclaredRows {

    private final Kick kick;
    private final FreshRows fresh;
    private final PackedContacts contacts;
    private final Rubbing rubbing;
    private final RunningRows running;
    private final TurningRows turning;
    private final BentRows bent;
    private final IslandImpacts impacts;

    /** Finds strays; null where a stray cannot land on another corner. */
    private final Strays strays;

    DeclaredRows(
            DataStorage data,
            Effects effects,
            Motions motions,
            PackedContacts contacts,
            Kick kick,
            FreshRows fresh,
            Straightness straight,
            SharedRows shared) {
        this.kick = kick;
        this.fresh = fresh;
        this.contacts = contacts;
        rubbing = rubbing(data, effects, motions, contacts);
        boolean runs = effects.declares(SurfaceSpeed.class);
        running = runs ? new RunningRows(data, contacts) : null;
        boolean turns = effects.declares(Rotation.class);
        turning = turns ? new TurningRows(data, motions, contacts, fresh, straight) : null;
        strays = turns && straight.follows ? new Strays(data, motions, contacts) : null;
        boolean curves = straight.follows;
        CurvedRows curved = curves ? new CurvedRows(data, motions, contacts, straight) : null;
        bent = new BentRows(contacts, fresh, turning, curved, shared);
        boolean bounces = effects.declares(Restitution.class);
        impacts =
                bounces
                        ? new IslandImpacts(data, motions, contacts, kick, straight.tolerance)
                        : null;
    }

    private static Rubbing rubbing(
            DataStorage data, Effects effects, Motions motions, PackedContacts contacts) {
        boolean rubs = effects.declares(Friction.class);
        FrictionSolver friction = rubs ? new FrictionSolver(motions, contacts, data.pairs) : null;
        if (effects.declares(RollingResistance.class)) {
            return new RollingSolver(data, motions, contacts, friction);
        }
        return rubs ? friction : new NoRubbing();
    }

    /** Friction and rolling resistance between surfaces. */
    Rubbing rubbing() {
        return rubbing;
    }

    /** Number of substeps that an island needs for the rest ({@code left} s) of a step. */
    int substepsFor(int island, double left, int usual) {
        return turning == null ? usual : turning.substepsFor(island, left, usual);
    }

    /**
     * Writes the rows of the packed island for substeps of h seconds; {@code worthOfImpacts} limits
     * the multiplications spent in this step on solving simultaneous impacts together.
     *
     * @param firstKick the length of the kick for which normal impulses were packed, s
     */
    void begin(double h, double firstKick, double worthOfImpacts) {
        bent.begin();
        rubbing.begin(firstKick);
        if (running != null) {
            running.begin();
        }
        if (impacts != null) {
            impacts.begin(h, worthOfImpacts);
        }
    }

    /**
     * Measures contacts of late joiners, and of outlines or normals that turn, before a part of a
     * substep that begins at a time, s; {@code left} seconds of the step remain.
     *
     * @param isFirst whether the part is the first of its substep
     * @return whether any contact is bent or was measured
     */
    boolean measureAnew(int substep, boolean isFirst, double time, double left) {
        if (impacts != null) {
            impacts.startAt(time);
        }
        boolean isAny = isFirst && fresh.measureJoining(substep, time, left);
        isAny |= bent.refresh(substep, isFirst, left);
        if (isAny) {
            rubbing.refresh();
        }
        return isAny;
    }

    /** Number of parts of a substep of h seconds in which no body turns by too much. */
    int partsFor(double h) {
        return turning == null ? 1 : turning.partsFor(h);
    }

    /**
     * Measures contacts of bodies that turn far in the next part of a substep, of h seconds; {@code
     * left} seconds of the step remain.
     *
     * @return whether any contact was measured
     */
    boolean measureTurned(double h, double left) {
        boolean isAny = turning.measureTurned(h, left);
        if (isAny) {
            rubbing.refresh();
        }
        return isAny;
    }

    /** Whether the packed island has contacts. */
    boolean areAnyContacts() {
        return contacts.count > 0;
    }

    /** Whether no body joins the packed island in a substep or after it. */
    boolean haveAllJoined(int substep) {
        return contacts.lastJoining <= substep;
    }

    /**
     * Measures contacts before a part of a substep of an island with joints; {@code left} seconds
     * of the step remain.
     */
    void measureJointed(int substep, boolean isFirst, double time, double left, double part) {
        if (contacts.count > 0) {
            measureAnew(substep, isFirst, time, left);
            bend(part, part);
        }
    }

    /**
     * Measures all contacts of an island with joints whose bodies turned far about them, {@code
     * left} seconds before the step ends: where they were measured last tells little.
     */
    void measureTurnedAbout(double left) {
        for (int row = 0; row < contacts.count; row++) {
            fresh.measure(row, left);
        }
        if (contacts.count > 0) {
            rubbing.refresh();
        }
    }

    /** Predicts how far all bodies move in the rest of the step, s, for {@link #measureStrays}. */
    void foresee(double left) {
        if (strays != null) {
            strays.begin(left);
        }
    }

    /**
     * Measures the contacts of strays again, for the rest of the step, s.
     *
     * @return whether any contact was measured
     */
    boolean measureStrays(double left) {
        if (strays == null || !strays.areAny(left)) {
            return false;
        }
        boolean isAny = false;
        for (int row = 0; row < contacts.count; row++) {
            if (strays.mayLackPoint(row)) {
                fresh.measure(row, left);
                isAny = true;
            }
        }
        if (isAny) {
            rubbing.refresh();
        }
        return isAny;
    }

    /** Time in s for which bodies that slide from one face to the next have no further points. */
    double untilNewPoints() {
        return bent.untilNewPoints();
    }

    /** Whether a normal or an outline has turned since the packed island began. */
    boolean isAnyBent() {
        return bent.isAnyBent();
    }

    /**
     * Predicts how far gaps open by turning outlines within h seconds, and by turning normals
     * within {@code closing} seconds, in which gaps may close.
     */
    void bend(double h, double closing) {
        bent.bend(h, closing);
    }

    /** Whether a contact may bounce within the next h seconds. */
    boolean mayStrike(double h, int substep) {
        return impacts != null && impacts.mayStrike(h, substep);
    }

    /**
     * Resolves the impacts in a substep of h seconds of an island that is solved whole.
     *
     * @return whether the rest of the step's budget was enough
     */
    boolean strikeJointly(double h, int substep) {
        if (impacts == null) {
            return true;
        }
        kick.measureGain();
        return impacts.resolveJointly(h, substep);
    }

    /**
     * Resolves impacts at the present velocities, within h seconds that count as no time.
     *
     * @return whether the rest of the step's budget was enough
     */
    boolean strikeAtOnce(double h, int substep) {
        return impacts == null || impacts.resolveAtOnce(h, substep);
    }

    /** Resolves the impacts in a substep of h seconds one after the other. */
    void strikeApart(double h, int substep) {
        if (impacts != null) {
            impacts.resolveApart(h, substep);
        }
    }

    /** In the last kick of a step, leaves out contacts that will bounce in the next step. */
    void leaveOpen(int substep) {
        if (impacts != null) {
            impacts.leaveOpen(substep);
        }
    }

    /** Number of tangential rows that a pass solves. */
    int rowCount() {
        return rubbing.rowCount();
    }

    /** Stores the tangential forces of the last substep of h seconds. */
    void store(double h) {
        rubbing.store(h);
    }
}
