package rigibo.lab.ablation.probe;

import java.util.List;
import java.util.Locale;

/** All workloads, by the words that name them to a process. */
public final class Workloads {

    private final List<Workload> scenes;
    private final List<Use> uses;

    /** Workloads whose random numbers come from a seed. */
    public Workloads(long seed) {
        scenes =
                List.of(
                        ProbeScenes.crate(),
                        ProbeScenes.wheel(),
                        ProbeScenes.friction(),
                        ProbeScenes.flood(seed),
                        ProbeScenes.flyers(seed),
                        ProbeScenes.heap(seed));
        uses = UseList.all(seed);
    }

    /** The scenes of the tables. */
    public List<Workload> scenes() {
        return scenes;
    }

    /** A use of every effect. */
    public List<Use> uses() {
        return uses;
    }

    /** The scene with a name. */
    public Workload scene(String name) {
        return scenes.stream()
                .filter(scene -> scene.name().equals(name))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException("there is no scene " + name));
    }

    /** The use of an effect with a simple name. */
    public Use use(String effect) {
        return uses.stream()
                .filter(use -> use.name().equals(effect))
                .findFirst()
                .orElseThrow(() -> new IllegalArgumentException(effect + " is not used"));
    }

    /**
     * The workload of some words: {@code crate}, {@code crate without Friction}, {@code crate
     * beside Friction}, {@code use Drag half declared}, {@code use Drag half undeclared}.
     */
    public Workload find(String words) {
        String[] word = words.split(" ");
        if (word[0].equals("use")) {
            Share share = Share.valueOf(word[2].toUpperCase(Locale.ROOT));
            Use use = use(word[1]);
            return word[3].equals("declared") ? use.declared(share) : use.undeclared(share);
        }
        Workload scene = scene(word[0]);
        boolean isWhole = word.length == 1 || word[1].equals("beside");
        return isWhole ? scene : LeftOut.of(scene, word[2]).rest();
    }

    /** The words for a scene without one of its effects. */
    public static String without(String scene, String effect) {
        return scene + " without " + effect;
    }

    /** The words for the whole scene, run at the same time as the one without that effect. */
    public static String beside(String scene, String effect) {
        return scene + " beside " + effect;
    }

    /** The words for an effect that a share of the bodies uses, declared or not. */
    public static String using(String effect, Share share, boolean isDeclared) {
        String users = share.name().toLowerCase(Locale.ROOT);
        return "use " + effect + " " + users + (isDeclared ? " declared" : " undeclared");
    }
}
