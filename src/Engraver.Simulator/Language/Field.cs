namespace Engraver.Simulator.Language;

/// <summary>One positional argument: left out, a question mark, or a value.</summary>
internal readonly record struct Field(bool IsQuery, FixedPoint? Value)
{
    public bool IsMissing => !IsQuery && Value is null;
}
