package rigibo;

import com.sun.management.GarbageCollectionNotificationInfo;

import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

import rigibo.frontend.catalog.Catalog;
import rigibo.frontend.display.Monkey;
import rigibo.frontend.scene.DisplayException;

import java.io.PrintWriter;
import java.lang.management.GarbageCollectorMXBean;
import java.lang.management.ManagementFactory;
import java.util.concurrent.Callable;
import java.util.concurrent.atomic.AtomicLong;

import javax.management.Notification;
import javax.management.NotificationEmitter;
import javax.management.openmbean.CompositeData;

/** Plays by random input, and reports exceptions, errors of OpenGL, and growth of memory. */
@Command(
        name = "monkey",
        description =
                "Gives real windows random input. Fails if an exception is thrown, OpenGL reports"
                        + " an error, or memory grows.")
final class MonkeyCommand implements Callable<Integer> {

    private static final int TURNS_PER_MINUTE = 3600;

    /** The growth of the heap that is allowed, MB: caches that fill once are no leak. */
    private static final double MOST_GROWTH = 16;

    private static final double MEGABYTE = 1 << 20;

    /** The cause of the collections that {@link #heap} asks for. */
    private static final String OURS = "System.gc()";

    /** The end of the names of concurrent collectors' work, which is no pause. */
    private static final String BESIDE = "Cycles";

    @Option(
            names = "--minutes",
            paramLabel = "M",
            defaultValue = "10",
            description = "How long it plays (default: ${DEFAULT-VALUE}).")
    private double minutes;

    @Option(
            names = "--seed",
            paramLabel = "N",
            defaultValue = "1",
            description = "Seed of the input (default: ${DEFAULT-VALUE}).")
    private long seed;

    @Spec private CommandSpec spec;

    /** The longest pause, ms. Another thread writes it. */
    private final AtomicLong longestPause = new AtomicLong();

    @Override
    public Integer call() {
        Options.requireMinutes(spec, "--minutes", minutes);
        PrintWriter out = spec.commandLine().getOut();
        listen();
        int turns = (int) Math.max(2, minutes * TURNS_PER_MINUTE);
        try {
            // The first fifth fills what is filled once: classes, caches, fonts.
            Monkey.Report first = Monkey.play(Catalog::menu, Catalog.entries(), turns / 5, seed);
            double before = heap();
            Monkey.Report rest =
                    Monkey.play(Catalog::menu, Catalog.entries(), turns - turns / 5, seed + 1);
            double growth = heap() - before;
            out.printf(
                    "%d turns in %d windows: %d complaints, the heap grew from %.1f by %.1f MB,"
                            + " pauses for garbage took %d ms at most%n",
                    first.turns() + rest.turns(),
                    first.windows() + rest.windows(),
                    first.troubles().size() + rest.troubles().size(),
                    before,
                    growth,
                    longestPause.get());
            first.troubles().forEach(out::println);
            rest.troubles().forEach(out::println);
            boolean isSound = first.troubles().isEmpty() && rest.troubles().isEmpty();
            return isSound && growth <= MOST_GROWTH ? 0 : 1;
        } catch (DisplayException e) {
            spec.commandLine().getErr().println(e.getMessage());
            return 1;
        }
    }

    /** The heap in use after a collection, MB. */
    private static double heap() {
        System.gc();
        Runtime runtime = Runtime.getRuntime();
        return (runtime.totalMemory() - runtime.freeMemory()) / MEGABYTE;
    }

    /** Records the pauses of collections that the game causes. */
    private void listen() {
        for (GarbageCollectorMXBean collector : ManagementFactory.getGarbageCollectorMXBeans()) {
            if (!collector.getName().endsWith(BESIDE)) {
                ((NotificationEmitter) collector)
                        .addNotificationListener((told, nothing) -> note(told), null, null);
            }
        }
    }

    private void note(Notification told) {
        var info = GarbageCollectionNotificationInfo.from((CompositeData) told.getUserData());
        if (!info.getGcCause().equals(OURS)) {
            longestPause.accumulateAndGet(info.getGcInfo().getDuration(), Math::max);
        }
    }
}
