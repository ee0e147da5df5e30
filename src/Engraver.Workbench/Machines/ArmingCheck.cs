namespace Engraver.Workbench.Machines;

/// <summary>One thing that must be so before a job may start.</summary>
/// <param name="Passed">True when it is so.</param>
/// <param name="Sentence">What was looked at, and when it is not so, what to do.</param>
public sealed record ArmingCheck(bool Passed, string Sentence)
{
    /// <summary>It does not stand in the way, but the operator must have read it.</summary>
    public bool IsWarning { get; init; }
}
