namespace Engraver.Core.Machines;

/// <summary>Kinds of <see cref="JobOutcome"/>.</summary>
public static class JobOutcomeKinds
{
    /// <summary>A section of the job is complete, and the rest continues when the operator continues it.</summary>
    public static bool IsSectionEnd(this JobOutcome outcome) => outcome is JobOutcome.ToolChange or JobOutcome.OperatorStop;

    /// <summary>The job reached the end of what it was to cut.</summary>
    public static bool IsAsPlanned(this JobOutcome outcome) => outcome == JobOutcome.Complete || outcome.IsSectionEnd();
}
