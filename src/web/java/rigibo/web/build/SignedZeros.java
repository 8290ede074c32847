package rigibo.web.build;

import org.teavm.model.BasicBlock;
import org.teavm.model.ClassHolder;
import org.teavm.model.ClassHolderTransformer;
import org.teavm.model.ClassHolderTransformerContext;
import org.teavm.model.Instruction;
import org.teavm.model.MethodHolder;
import org.teavm.model.Program;
import org.teavm.model.Variable;
import org.teavm.model.instructions.BinaryInstruction;
import org.teavm.model.instructions.BinaryOperation;
import org.teavm.model.instructions.DoubleConstantInstruction;
import org.teavm.model.instructions.NegateInstruction;
import org.teavm.model.instructions.NumericOperandType;

import java.util.ArrayList;
import java.util.List;

/**
 * Replaces −x by −1 · x, which is equal for every double. TeaVM compiles −x to 0 − x, which is +0
 * for +0, where Java's result is −0.
 */
public final class SignedZeros implements ClassHolderTransformer {

    @Override
    public void transformClass(ClassHolder holder, ClassHolderTransformerContext context) {
        for (MethodHolder method : holder.getMethods()) {
            if (method.getProgram() != null) {
                transform(method.getProgram());
            }
        }
    }

    private static void transform(Program program) {
        for (BasicBlock block : program.getBasicBlocks()) {
            for (NegateInstruction negation : negationsOf(block)) {
                replace(program, negation);
            }
        }
    }

    private static List<NegateInstruction> negationsOf(BasicBlock block) {
        List<NegateInstruction> negations = new ArrayList<>();
        for (Instruction instruction : block) {
            if (instruction instanceof NegateInstruction) {
                NegateInstruction negation = (NegateInstruction) instruction;
                if (negation.getOperandType() == NumericOperandType.DOUBLE) {
                    negations.add(negation);
                }
            }
        }
        return negations;
    }

    private static void replace(Program program, NegateInstruction negation) {
        Variable minusOne = program.createVariable();
        DoubleConstantInstruction constant = new DoubleConstantInstruction();
        constant.setConstant(-1);
        constant.setReceiver(minusOne);
        constant.setLocation(negation.getLocation());
        BinaryInstruction product =
                new BinaryInstruction(BinaryOperation.MULTIPLY, NumericOperandType.DOUBLE);
        product.setFirstOperand(minusOne);
        product.setSecondOperand(negation.getOperand());
        product.setReceiver(negation.getReceiver());
        product.setLocation(negation.getLocation());
        negation.insertPrevious(constant);
        negation.replace(product);
    }
}
