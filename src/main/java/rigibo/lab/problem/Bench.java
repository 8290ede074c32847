package rigibo.lab.problem;

import rigibo.backend.effect.Effects;
import rigibo.lab.child.Work;
import rigibo.lab.engine.Engine;
import rigibo.lab.engine.Setting;
import rigibo.lab.engine.World;

import java.util.ArrayList;
import java.util.List;

/** Makes worlds of one engine at one setting for a problem, and counts their work. */
public final class Bench implements AutoCloseable {

    private final Engine engine;
    private final Setting setting;
    private final boolean isCounting;
    private final List<World> worlds = new ArrayList<>();
    private final StepTally tally = new StepTally();
    private Work work = Work.NONE;
    private long steps;

    private Bench(Engine engine, Setting setting, boolean isCounting) {
        this.engine = engine;
        this.setting = setting;
        this.isCounting = isCounting;
    }

    /** A bench that counts the work of its steps. */
    public static Bench counting(Engine engine, Setting setting) {
        return new Bench(engine, setting, true);
    }

    /** A bench that makes steps for timing and counts nothing. */
    public static Bench timed(Engine engine, Setting setting) {
        return new Bench(engine, setting, false);
    }

    /** A world without bodies, closed with this bench. */
    public World world(Effects effects) {
        World world = engine.world(effects, setting);
        worlds.add(world);
        return world;
    }

    /** Whether errors are computed; otherwise steps are timed, and nothing else is computed. */
    public boolean isCounting() {
        return isCounting;
    }

    /** Length of a step, s. */
    public double step() {
        return setting.step();
    }

    /** Makes a step in a world. */
    public void step(World world) {
        if (isCounting && (worlds.size() == 1 || world != worlds.get(0))) {
            tally.measure(
                    () -> {
                        world.step(setting.step());
                        return 1;
                    });
        } else {
            world.step(setting.step());
        }
        if (isCounting) {
            work = work.plus(world.lastStep());
        }
        steps++;
    }

    /** The number of steps nearest to a time in s. */
    public int stepsIn(double seconds) {
        return (int) Math.round(seconds / setting.step());
    }

    /** Steps made so far, of all worlds together. */
    public long steps() {
        return steps;
    }

    /**
     * The times of the steps of a counting bench. If there are several worlds, the first is left
     * out, in which Java compiles the engine.
     */
    public StepTally tally() {
        return tally;
    }

    /** The work of all steps so far, if it is counted. */
    public Work work() {
        return work;
    }

    @Override
    public void close() {
        worlds.forEach(World::close);
    }
}
