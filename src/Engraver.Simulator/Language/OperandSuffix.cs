namespace Engraver.Simulator.Language;

/// <summary>What stands behind the two letters of an operand: nothing, an axis, a plane, a digit, or a handle and a digit.</summary>
internal readonly record struct OperandSuffix(char First, char Second, int Length)
{
    public static OperandSuffix Of(ReadOnlySpan<char> text) =>
        new(text.Length > 0 ? text[0] : '\0', text.Length > 1 ? text[1] : '\0', text.Length);
}
