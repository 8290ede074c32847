package rigibo.frontend.menu;

import rigibo.frontend.scene.LevelProgress;
import rigibo.frontend.scene.Progress;

import java.util.List;

/**
 * The order of levels before there were worlds, when each level opened the next. Levels that were
 * open then stay open, although progress records only levels that were played.
 */
final class FormerOrder {

    private static final List<String> IDS =
            List.of(
                    "two-storeys",
                    "tilt",
                    "seesaw",
                    "icebreaker",
                    "newtons-row",
                    "trampoline",
                    "conveyor",
                    "heavy-on-light",
                    "keystone-arch",
                    "flooded",
                    "moon",
                    "two-balls",
                    "counterweight",
                    "dominoes",
                    "tower-of-ten",
                    "snip",
                    "trapdoor",
                    "switch",
                    "fuse",
                    "breeze",
                    "let-go");

    private FormerOrder() {}

    /** Whether the level before this one was solved. */
    static boolean opened(String id, Progress progress) {
        int place = IDS.indexOf(id);
        LevelProgress before = place < 1 ? null : progress.levels().get(IDS.get(place - 1));
        return before != null && before.isSolved();
    }
}
