package rigibo.lab.hardcase;

import java.util.ArrayList;
import java.util.List;

/** Cases in the order they are told. */
final class CaseList {

    private final List<HardCase> cases = new ArrayList<>();

    /** Adds a case that is counted, and held to its limits, at every preset. */
    CaseList add(String row, String title, Scenes scenes) {
        return add(HardCase.of(row, title, scenes));
    }

    /** Adds a case of which DRAFT is held to what is true in every case alone. */
    CaseList fromGame(String row, String title, Scenes scenes) {
        return add(HardCase.of(row, title, scenes).limitedFrom(Preset.GAME));
    }

    /** DRAFT leaves impacts to the one solve of a pile that a step has. */
    CaseList ofImpacts(String row, String title, Scenes scenes) {
        return fromGame(row, title, scenes);
    }

    /** DRAFT takes a force that changes along the way once a step. */
    CaseList ofFields(String row, String title, Scenes scenes) {
        return fromGame(row, title, scenes);
    }

    /** One substep a step is too few for what turns on a corner. */
    CaseList ofCorners(String row, String title, Scenes scenes) {
        return fromGame(row, title, scenes);
    }

    private CaseList add(HardCase one) {
        cases.add(one);
        return this;
    }

    /** Says why the last one added does not reach its truth everywhere. */
    CaseList finding(String words) {
        int last = cases.size() - 1;
        cases.set(last, cases.get(last).finding(words));
        return this;
    }

    /** Has the last one added counted from a preset on. */
    CaseList fastest(Preset preset) {
        int last = cases.size() - 1;
        cases.set(last, cases.get(last).fastest(preset));
        return this;
    }

    List<HardCase> all() {
        return List.copyOf(cases);
    }
}
