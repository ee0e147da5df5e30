namespace Engraver.Simulator.Language;

/// <summary>The suffix after the two letters of an operand: nothing, an axis, a plane, a digit, or a handle and a digit.</summary>
internal readonly record struct OperandSuffix(char First, char Second, int Length)
{
    public static OperandSuffix Parse(ReadOnlySpan<char> text) =>
        new(text.Length > 0 ? text[0] : '\0', text.Length > 1 ? text[1] : '\0', text.Length);
}
