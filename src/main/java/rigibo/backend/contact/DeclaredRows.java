package rigibo.backend.contact;

import rigibo.backend.contact.bounce.IslandImpacts;
import rigibo.backend.contact.row.BentRows;
import rigibo.backend.contact.row.CurvedRows;
import rigibo.backend.contact.row.FreshRows;
import rigibo.backend.contact.row.Kick;
import rigibo.backend.contact.row.Motions;
import rigibo.backend.contact.row.PackedContacts;
import rigibo.backend.contact.row.RunningRows;
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
 * What the declared effects ask of the contacts of an island. What is not declared is null here,
 * and asked for once per substep, not once per contact; its classes are not even loaded.
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

    /** Who goes farther than foreseen, or null where that cannot bring another corner to land. */
    private final Strays strays;

    DeclaredRows(
            DataStorage data,
            Effects effects,
            Motions motions,
            PackedContacts contacts,
            Kick kick,
            FreshRows fresh,
            Straightness straight) {
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
        bent = new BentRows(contacts, fresh, turning, curved);
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

    /** What surfaces do to each other. */
    Rubbing rubbing() {
        return rubbing;
    }

    /** How many substeps an island needs for the rest of a step, {@code left} seconds. */
    int substepsFor(int island, double left, int usual) {
        return turning == null ? usual : turning.substepsFor(island, left, usual);
    }

    /**
     * Writes the rows of the packed island for substeps of h seconds. To answer its impacts jointly
     * is worth so many multiplications in this step.
     */
    void begin(double h, double worthOfImpacts) {
        bent.begin();
        rubbing.begin(h / 2);
        if (running != null) {
            running.begin();
        }
        if (impacts != null) {
            impacts.begin(h, worthOfImpacts);
        }
    }

    /**
     * Measures what joins, turns or goes round, before a part of a substep, the first one or
     * another, that begins at a time, with {@code left} seconds to go.
     *
     * @return whether there was anything
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

    /** In how many parts of a substep of h seconds bodies turn so far that it counts. */
    int partsFor(double h) {
        return turning == null ? 1 : turning.partsFor(h);
    }

    /**
     * Measures what turns far in the next part of a substep, of h seconds, with {@code left}
     * seconds of the step to go.
     *
     * @return whether there was anything
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

    /** Whether nothing joins the packed island in a substep or after it. */
    boolean haveAllJoined(int substep) {
        return contacts.lastJoining <= substep;
    }

    /**
     * Measures before a part of so many seconds of a substep of an island with joints, which has
     * {@code left} seconds of the step to go.
     */
    void measureJointed(int substep, boolean isFirst, double time, double left, double part) {
        if (contacts.count > 0) {
            measureAnew(substep, isFirst, time, left);
            bend(part, part);
        }
    }

    /**
     * Foresees how far all bodies go in what is left of the step, s, for {@link #measureStrays}.
     */
    void foresee(double left) {
        if (strays != null) {
            strays.begin(left);
        }
    }

    /**
     * Measures anew what bodies touch that go farther in what is left of the step, s.
     *
     * @return whether there was anything
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

    /** How long the points of what slides from one face to the next are all that there are, s. */
    double untilNewPoints() {
        return bent.untilNewPoints();
    }

    /** Whether a normal or an outline has turned since the packed island began. */
    boolean isAnyBent() {
        return bent.isAnyBent();
    }

    /**
     * Foresees what gaps do by bending within h seconds; those of curves within as many as gaps may
     * close in.
     */
    void bend(double h, double closing) {
        bent.bend(h, closing);
    }

    /**
     * Resolves the impacts in a substep of h seconds of a pile that is solved whole.
     *
     * @return whether what was left of the step's work was enough for that
     */
    boolean strikeJointly(double h, int substep) {
        if (impacts == null) {
            return true;
        }
        kick.measureGain();
        return impacts.resolveJointly(h, substep);
    }

    /** Resolves impacts at the velocities as they are, within next to no time. */
    boolean strikeAtOnce(double h, int substep) {
        return impacts == null || impacts.resolveAtOnce(h, substep);
    }

    /** Resolves the impacts in a substep of h seconds one after the other. */
    void strikeApart(double h, int substep) {
        if (impacts != null) {
            impacts.resolveApart(h, substep);
        }
    }

    /** Leaves what is about to bounce to the next step, in the kick that ends this one. */
    void leaveOpen(int substep) {
        if (impacts != null) {
            impacts.leaveOpen(substep);
        }
    }

    /** How many rows a pass along the tangents solves. */
    int rowCount() {
        return rubbing.rowCount();
    }

    /** Keeps what held in the last substep of h seconds. */
    void store(double h) {
        rubbing.store(h);
    }
}
