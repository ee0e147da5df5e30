namespace Engraver.App.Jobs;

/// <summary>One thing that must be so before a job may start.</summary>
public sealed record CheckLine(bool Passed, string Sentence)
{
    /// <summary>Shape besides colour.</summary>
    public string Mark => Passed ? "✓" : "✗";
}
