package rigibo.frontend.puzzle.level;

import rigibo.frontend.document.Fault;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;

/** E153 a star that no game, or every game, would earn. */
final class StarRules {

    private final LevelSketch sketch;

    private StarRules(LevelSketch sketch) {
        this.sketch = sketch;
    }

    static void check(LevelSketch sketch) {
        StarRules rules = new StarRules(sketch);
        sketch.star()
                .filter(star -> !sketch.json().isSpoilt(star.pointer()))
                .flatMap(star -> rules.fault(star.part().feat()))
                .ifPresent(fault -> sketch.json().error(LevelSketch.STAR, () -> fault));
    }

    private Optional<Fault> fault(Feat feat) {
        if (feat instanceof Feat.Clicks clicks) {
            return sketch.limits().flatMap(limits -> clicks(clicks.count(), limits.part()));
        }
        if (feat instanceof Feat.Quick quick) {
            return sketch.limits().flatMap(limits -> quick(quick.seconds(), limits.part()));
        }
        if (feat instanceof Feat.AvoidMaterial avoid) {
            boolean isThere =
                    bodies().stream().anyMatch(body -> body.substance() == avoid.material());
            String title = avoid.material().title();
            return told(!isThere, "E153.material", "nothing is of %s", title)
                    .map(fault -> fault.naming("@editor.material." + title));
        }
        if (feat instanceof Feat.Keep keep) {
            boolean stays =
                    bodies().stream()
                            .anyMatch(body -> body.id().equals(keep.body()) && stays(body));
            return told(stays, "E153.keep", "\"%s\" stays in the world in any game", keep.body());
        }
        if (feat instanceof Feat.Clear) {
            boolean isAny = bodies().stream().anyMatch(LevelBody::deletable);
            return told(!isAny, "E153.clear", "nothing can be deleted");
        }
        if (feat instanceof Feat.Inside) {
            boolean isAny = bodies().stream().anyMatch(LevelBody::isDynamic);
            return told(!isAny, "E153.inside", "no body can fall out of the world");
        }
        return feat instanceof Feat.First first ? first(first.target()) : Optional.empty();
    }

    private static Optional<Fault> told(
            boolean isFault, String kind, String words, Object... values) {
        return isFault ? Optional.of(Fault.of(kind, "E153 " + words, values)) : Optional.empty();
    }

    private List<LevelBody> bodies() {
        return sketch.bodies().stream().map(Located::part).toList();
    }

    private static boolean stays(LevelBody body) {
        return !body.isDynamic() && body.verb().filter(Verb.DELETE::equals).isEmpty();
    }

    private Optional<Fault> clicks(int count, Limits limits) {
        OptionalInt most = limits.maxClicks();
        if (count < limits.par()) {
            String words = "no game is solved with %s clicks, par is %s";
            return told(true, "E153.par", words, count, limits.par());
        }
        if (most.isPresent() && count > most.getAsInt()) {
            return told(true, "E153.rules", "%s clicks are more than the rules allow", count);
        }
        List<Clickable> all = clickables();
        boolean isOnceEach = all.stream().noneMatch(one -> one.verb().repeats());
        boolean isTooMany = isOnceEach && count > all.size();
        return told(isTooMany, "E153.things", "only %s can be clicked", all.size());
    }

    private static Optional<Fault> quick(double seconds, Limits limits) {
        String words = "the hold alone takes %s s, the star allows %s s";
        return told(seconds <= limits.hold(), "E153.hold", words, limits.hold(), seconds);
    }

    private Optional<Fault> first(String target) {
        List<String> ids = clickables().stream().map(Clickable::id).toList();
        if (!ids.contains(target)) {
            return told(true, "E153.click", "a click does nothing to \"%s\"", target);
        }
        String words = "every game begins with \"%s\", for nothing else can be clicked";
        return told(ids.size() == 1, "E153.only", words, target);
    }

    private List<Clickable> clickables() {
        List<LevelJoint> joints = sketch.joints().stream().map(Located::part).toList();
        return Level.clickables(bodies(), joints);
    }
}
