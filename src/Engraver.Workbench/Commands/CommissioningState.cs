namespace Engraver.Workbench.Commands;

/// <summary>State of a step.</summary>
public enum CommissioningState
{
    /// <summary>Not started, or cancelled.</summary>
    Open,

    /// <summary>The step is asked about or in progress.</summary>
    InProgress,

    /// <summary>Completed; values answered with Enter are unchanged.</summary>
    Done,

    /// <summary>Skipped by the operator.</summary>
    Skipped,

    /// <summary>Started but not completed: a move was stopped, refused or declined, or something has to be repaired first.</summary>
    Unfinished,
}
