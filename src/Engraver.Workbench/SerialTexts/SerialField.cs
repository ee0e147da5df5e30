namespace Engraver.Workbench.SerialTexts;

/// <summary>What is between two pairs of brackets in the string of a text, <c>[[n:0000]]</c>.</summary>
/// <param name="At">Index of the first bracket.</param>
/// <param name="Written">With its brackets.</param>
public abstract record SerialField(int At, string Written)
{
    /// <summary>Index after the last bracket.</summary>
    public int End => At + Written.Length;

    /// <summary><c>[[n NAME:0000;start=17;step=5]]</c>.</summary>
    /// <param name="Digits">1: as many as the number has. From 2 on exactly so many, with zeros in front.</param>
    /// <param name="Start">First number of a counter that the book does not have; null where it is not stated.</param>
    /// <param name="Increment">From one plate to the next; null where it is not stated.</param>
    public sealed record Counter(int At, string Written, string Name, int Digits, long? Start, long? Increment) : SerialField(At, Written);

    /// <summary><c>[[date:yyyy-MM-dd]]</c>.</summary>
    public sealed record Date(int At, string Written, DateFormat Format) : SerialField(At, Written);

    /// <summary><c>[[csv:NAME]]</c>, or <c>[[csv:NAME?]]</c> for a column that may be empty.</summary>
    public sealed record Column(int At, string Written, string Name, bool IsOptional) : SerialField(At, Written);

    /// <summary><c>[[copy:000]]</c>.</summary>
    /// <param name="Digits">As for a counter.</param>
    public sealed record Copy(int At, string Written, int Digits) : SerialField(At, Written);

    /// <summary>A field that is not known, or that is written wrongly.</summary>
    /// <param name="Reason">Why, without a full stop.</param>
    public sealed record Invalid(int At, string Written, string Reason) : SerialField(At, Written);

    /// <summary>Brackets that do not have the form of a field: they remain text.</summary>
    public sealed record Brackets(int At, string Written) : SerialField(At, Written);
}
