package rigibo.frontend.save;

import rigibo.frontend.document.Value;
import rigibo.frontend.scene.DayResult;
import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Progress;
import rigibo.frontend.scene.Totals;

import tools.jackson.databind.node.ObjectNode;

import java.time.LocalDate;
import java.time.format.DateTimeParseException;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.regex.Pattern;

/** Progress in JSON. Hashes are hexadecimal text, since JSON numbers need not have 64 bits. */
final class ProgressFormat implements Format<Progress> {

    /** Largest whole number in a file. */
    private static final int MOST = Integer.MAX_VALUE;

    private static final Pattern HASH = Pattern.compile("[0-9a-fA-F]{1,16}");

    @Override
    public Progress initial() {
        return Progress.none();
    }

    @Override
    public Progress read(Value json) {
        SortedMap<String, LevelProgress> levels = new TreeMap<>();
        Value all = json.required("levels").object();
        for (String id : all.members()) {
            levels.put(id, level(all.required(id).object()));
        }
        return new Progress(
                levels,
                days(json.optional("days")),
                json.optional("endless").whole(1, MOST, 1),
                totals(json.optional("totals")));
    }

    /** Totals, which files before them do not have. */
    private static Totals totals(Value json) {
        if (!json.isThere()) {
            return Totals.NONE;
        }
        Value all = json.object();
        return new Totals(
                all.required("tries").whole(0, MOST, 0),
                all.required("clicks").whole(0, MOST, 0),
                all.required("steps").whole(0, MOST, 0));
    }

    /** The results of days, which files before them do not have. */
    private static SortedMap<LocalDate, DayResult> days(Value json) {
        SortedMap<LocalDate, DayResult> days = new TreeMap<>();
        if (json.isThere()) {
            for (String date : json.object().members()) {
                Value day = json.required(date).object();
                date(date, day).ifPresent(found -> days.put(found, result(day)));
            }
        }
        return days;
    }

    private static Optional<LocalDate> date(String name, Value day) {
        try {
            return Optional.of(LocalDate.parse(name));
        } catch (DateTimeParseException none) {
            day.wrong("must have a date as its name, like 2026-11-27");
            return Optional.empty();
        }
    }

    private static DayResult result(Value day) {
        return new DayResult(
                day.required("clicks").whole(1, MOST, 1), day.required("steps").whole(1, MOST, 1));
    }

    private static LevelProgress level(Value json) {
        boolean isSolved = json.required("solved").truth(false);
        return new LevelProgress(
                hash(json.required("hash")),
                isSolved,
                clicks(json.optional("fewestClicks"), isSolved),
                json.required("failures").whole(0, MOST, 0),
                star(json.optional("star"), isSolved));
    }

    private static long hash(Value json) {
        return Long.parseUnsignedLong(json.text(HASH, "1 to 16 hexadecimal digits", "0"), 16);
    }

    private static OptionalInt clicks(Value json, boolean isSolved) {
        if (!json.isThere()) {
            return OptionalInt.empty();
        }
        int clicks = json.whole(0, MOST, 0);
        if (!isSolved) {
            json.wrong("must be missing until the level is solved");
        }
        return isSolved ? OptionalInt.of(clicks) : OptionalInt.empty();
    }

    /** Files before there were stars do not have it. */
    private static boolean star(Value json, boolean isSolved) {
        boolean hasStar = json.truth(false);
        if (hasStar && !isSolved) {
            json.wrong("must be missing until the level is solved");
        }
        return hasStar && isSolved;
    }

    @Override
    public void write(Progress progress, ObjectNode json) {
        ObjectNode levels = json.putObject("levels");
        progress.levels().forEach((id, level) -> write(level, levels.putObject(id)));
        ObjectNode days = json.putObject("days");
        progress.days()
                .forEach(
                        (date, result) ->
                                days.putObject(date.toString())
                                        .put("clicks", result.clicks())
                                        .put("steps", result.steps()));
        json.put("endless", progress.endless());
        json.putObject("totals")
                .put("tries", progress.totals().tries())
                .put("clicks", progress.totals().clicks())
                .put("steps", progress.totals().steps());
    }

    private static void write(LevelProgress level, ObjectNode json) {
        json.put("hash", Long.toHexString(level.levelHash()));
        json.put("solved", level.isSolved());
        level.fewestClicks().ifPresent(clicks -> json.put("fewestClicks", clicks));
        json.put("failures", level.failures());
        if (level.hasStar()) {
            json.put("star", true);
        }
    }

    /** Totals that both games count: the file gets what this game has added. */
    @Override
    public Progress merged(Progress before, Progress onDisk, Progress own) {
        Totals added = own.totals().since(before.totals());
        return own.with(onDisk).withTotals(onDisk.totals().plus(added));
    }
}
