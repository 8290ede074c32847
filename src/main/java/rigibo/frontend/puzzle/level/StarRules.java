package rigibo.frontend.puzzle.level;

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
                .ifPresent(fault -> sketch.json().error(LevelSketch.STAR, () -> "E153 " + fault));
    }

    private Optional<String> fault(Feat feat) {
        if (feat instanceof Feat.Clicks clicks) {
            return sketch.limits().flatMap(limits -> clicks(clicks.count(), limits.part()));
        }
        if (feat instanceof Feat.Quick quick) {
            return sketch.limits().flatMap(limits -> quick(quick.seconds(), limits.part()));
        }
        if (feat instanceof Feat.AvoidMaterial avoid) {
            boolean isThere =
                    bodies().stream().anyMatch(body -> body.substance() == avoid.material());
            return told(!isThere, "nothing is of " + avoid.material().title());
        }
        if (feat instanceof Feat.Keep keep) {
            boolean stays =
                    bodies().stream()
                            .anyMatch(body -> body.id().equals(keep.body()) && stays(body));
            return told(stays, "\"" + keep.body() + "\" stays in the world in any game");
        }
        if (feat instanceof Feat.Clear) {
            boolean isAny = bodies().stream().anyMatch(LevelBody::deletable);
            return told(!isAny, "nothing can be deleted");
        }
        if (feat instanceof Feat.Inside) {
            boolean isAny = bodies().stream().anyMatch(LevelBody::isDynamic);
            return told(!isAny, "no body can fall out of the world");
        }
        return feat instanceof Feat.First first ? first(first.target()) : Optional.empty();
    }

    private static Optional<String> told(boolean isFault, String words) {
        return isFault ? Optional.of(words) : Optional.empty();
    }

    private List<LevelBody> bodies() {
        return sketch.bodies().stream().map(Located::part).toList();
    }

    private static boolean stays(LevelBody body) {
        return !body.isDynamic() && body.verb().filter(Verb.DELETE::equals).isEmpty();
    }

    private Optional<String> clicks(int count, Limits limits) {
        OptionalInt most = limits.maxClicks();
        if (count < limits.par()) {
            return Optional.of(
                    "no game is solved with " + count + " clicks, par is " + limits.par());
        }
        if (most.isPresent() && count > most.getAsInt()) {
            return Optional.of(count + " clicks are more than the rules allow");
        }
        List<Clickable> all = clickables();
        boolean isOnceEach = all.stream().noneMatch(one -> one.verb().repeats());
        return told(isOnceEach && count > all.size(), "only " + all.size() + " can be clicked");
    }

    private static Optional<String> quick(double seconds, Limits limits) {
        return told(
                seconds <= limits.hold(),
                "the hold alone takes " + limits.hold() + " s, the star allows " + seconds + " s");
    }

    private Optional<String> first(String target) {
        List<String> ids = clickables().stream().map(Clickable::id).toList();
        if (!ids.contains(target)) {
            return Optional.of("a click does nothing to \"" + target + "\"");
        }
        return told(
                ids.size() == 1,
                "every game begins with \"" + target + "\", for nothing else can be clicked");
    }

    private List<Clickable> clickables() {
        List<LevelJoint> joints = sketch.joints().stream().map(Located::part).toList();
        return Level.clickables(bodies(), joints);
    }
}
