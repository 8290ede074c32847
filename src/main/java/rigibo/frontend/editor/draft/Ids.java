package rigibo.frontend.editor.draft;

import java.util.Set;
import java.util.stream.Collectors;

/** Makes ids for bodies and joints, which must be unique in a level. */
final class Ids {

    private Ids() {}

    /** The word with the smallest number that neither a body nor a joint of the draft has. */
    static String free(Draft draft, String word) {
        Set<String> taken = draft.items().stream().map(Item::id).collect(Collectors.toSet());
        taken.addAll(JointEntry.ids(draft));
        int number = 1;
        while (taken.contains(word + number)) {
            number++;
        }
        return word + number;
    }
}
