package rigibo.frontend.gallery;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;

/** Every registered exhibit, in the order of registration. */
public final class Exhibits {

    private Exhibits() {}

    /** All exhibits. */
    public static List<Found> all() {
        return Registered.all();
    }

    static Optional<Found> named(String name) {
        return all().stream().filter(found -> found.name().equals(name)).findFirst();
    }

    /** The exhibits by section, with the sections in the order of their first exhibits. */
    public static Map<String, List<Found>> bySection() {
        return all().stream()
                .collect(
                        Collectors.groupingBy(
                                Found::section, LinkedHashMap::new, Collectors.toList()));
    }

    /** Returns the exhibit before (−1) or after (1) another one; after the last comes the first. */
    static Found beside(Found found, int direction) {
        List<Found> all = all();
        int at = all.stream().map(Found::type).toList().indexOf(found.type());
        return all.get(Math.floorMod(at + direction, all.size()));
    }
}
