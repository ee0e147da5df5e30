using Engraver.Simulator.Values;

namespace Engraver.Simulator.Language;

/// <summary>One positional argument: omitted, a question mark, or a value.</summary>
internal readonly record struct Field(bool IsQuery, FixedPoint? Value)
{
    public bool IsMissing => !IsQuery && Value is null;
}
