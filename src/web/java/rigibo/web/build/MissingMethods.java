package rigibo.web.build;

import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.MethodReference;
import org.teavm.model.ValueType;
import org.teavm.model.Variable;
import org.teavm.model.instructions.InvocationType;
import org.teavm.model.instructions.InvokeInstruction;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * Replaces calls of methods that TeaVM lacks, or has with an error, by calls of {@code
 * rigibo.web.library.Missing}.
 */
public final class MissingMethods implements ClassHolderTransformer {

    private static final String OURS = "rigibo.web.library.Missing";

    private static final Set<String> STATIC =
            Set.of(
                    "java.lang.String.format",
                    "java.util.Locale.forLanguageTag",
                    "java.lang.Character.toString",
                    "java.lang.Math.toDegrees",
                    "java.lang.Math.toRadians",
                    "java.text.Normalizer.normalize",
                    "java.util.Collections.emptySortedMap",
                    "java.util.Collections.shuffle",
                    "java.util.Collections.unmodifiableSortedMap",
                    "java.lang.Long.parseUnsignedLong",
                    "java.nio.file.Files.readString",
                    "java.nio.file.Files.createDirectories");

    private static final Set<String> OF_OBJECTS =
            Set.of(
                    "java.util.regex.Matcher.replaceAll(Ljava/util/function/Function;)",
                    "java.util.List.parallelStream()",
                    "java.lang.String.lines()",
                    "java.lang.Class.getPackageName()");

    @Override
    public void transformClass(ClassHolder holder, ClassHolderTransformerContext context) {
        if (holder.getName().equals(OURS)) {
            return;
        }
        for (MethodHolder method : holder.getMethods()) {
            if (method.getProgram() != null) {
                for (BasicBlock block : method.getProgram().getBasicBlocks()) {
                    transform(block);
                }
            }
        }
    }

    private static void transform(BasicBlock block) {
        for (Instruction instruction : block) {
            if (instruction instanceof InvokeInstruction call) {
                MethodReference called = call.getMethod();
                if (STATIC.contains(called.getClassName() + "." + called.getName())) {
                    call.setMethod(new MethodReference(OURS, called.getDescriptor()));
                } else if (OF_OBJECTS.contains(called.getClassName() + "." + parameters(called))) {
                    callWithObject(call);
                }
            }
        }
    }

    private static String parameters(MethodReference called) {
        String descriptor = called.getDescriptor().toString();
        return descriptor.substring(0, descriptor.indexOf(')') + 1);
    }

    /** Makes the object of a call its first argument. */
    private static void callWithObject(InvokeInstruction call) {
        MethodReference called = call.getMethod();
        List<ValueType> signature = new ArrayList<>(List.of(called.getSignature()));
        signature.add(0, ValueType.object(called.getClassName()));
        List<Variable> arguments = new ArrayList<>(call.getArguments());
        arguments.add(0, call.getInstance());
        call.setMethod(
                new MethodReference(OURS, called.getName(), signature.toArray(new ValueType[0])));
        call.setInstance(null);
        call.setType(InvocationType.SPECIAL);
        call.setArguments(arguments.toArray(new Variable[0]));
    }
}
