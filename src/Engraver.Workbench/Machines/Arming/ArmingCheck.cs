namespace Engraver.Workbench.Machines.Arming;

/// <summary>One start check.</summary>
/// <param name="Passed">True if it passed.</param>
/// <param name="Message">What was checked and, if it failed, what to do.</param>
public sealed record ArmingCheck(bool Passed, string Message)
{
    /// <summary>True if it does not prevent arming, but the operator must acknowledge it.</summary>
    public bool IsWarning { get; init; }

    /// <summary>False if the value from the controller is outdated and therefore unknown.</summary>
    public bool IsCurrent { get; init; } = true;

    /// <summary>True for information that is neither passed nor failed.</summary>
    public bool IsNote { get; init; }

    /// <summary>True for a finding of the drawing, which is also in the list of findings.</summary>
    public bool IsFinding { get; init; }

    /// <summary>The displayed line.</summary>
    public string Line => Wording.Get(this switch { { IsNote: true } => "CncArm.Note", { IsWarning: true } => "CncArm.Warning", { IsCurrent: false } => "CncArm.Unknown", { Passed: true } => "CncArm.Ok", _ => "CncArm.NotOk" }, Message);
}
