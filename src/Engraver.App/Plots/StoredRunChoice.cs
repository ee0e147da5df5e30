using Engraver.App.Texts;

namespace Engraver.App.Plots;

/// <summary>A stored run that can be compared, or none.</summary>
/// <param name="Journal">Its journal; null for none.</param>
public sealed record StoredRunChoice(string? Journal)
{
    public static StoredRunChoice None { get; } = new((string?)null);

    public override string ToString() => Journal is null ? Text.Get("Plots.CompareNone") : Path.GetFileNameWithoutExtension(Journal);
}
