using System.Globalization;

namespace Engraver.App.Programs;

/// <summary>A line of the controller's program.</summary>
public sealed class ProgramRow(int index, string text) : IEquatable<ProgramRow>
{
    public int Index => index;

    public string Number => (index + 1).ToString(CultureInfo.InvariantCulture);

    public string Text => text;

    public bool Equals(ProgramRow? other) => other is not null && other.Index == index;

    public override bool Equals(object? obj) => Equals(obj as ProgramRow);

    public override int GetHashCode() => index;
}
