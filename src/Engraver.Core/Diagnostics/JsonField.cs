namespace Engraver.Core.Diagnostics;

/// <summary>A field of a JSON file.</summary>
/// <param name="Owner">Path of the field that contains it; empty for the file itself.</param>
/// <param name="Name">As written in the file.</param>
/// <param name="Line">From 1.</param>
public readonly record struct JsonField(string Owner, string Name, long Line)
{
    public string Path => Owner.Length == 0 ? Name : $"{Owner}.{Name}";

    /// <summary>Its value where that is a text; null for any other value.</summary>
    public string? Text { get; init; }
}
