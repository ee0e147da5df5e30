namespace Engraver.Workbench.Commands;

/// <summary>The steps of CNCCOMMISSION and the state of the last run, for display. Any thread.</summary>
/// <param name="names">The names of the steps in the current language.</param>
public sealed class CommissioningCourse(Func<IReadOnlyList<string>> names)
{
    private volatile IReadOnlyDictionary<int, CommissioningState> _states = new Dictionary<int, CommissioningState>();
    private volatile bool _isUnderWay;

    /// <summary>True from the first question to the last.</summary>
    public bool IsUnderWay => _isUnderWay;

    public IReadOnlyList<CommissioningStepView> Steps => [.. names().Select((name, i) => new CommissioningStepView(i + 1, name, _states.GetValueOrDefault(i)))];

    internal void Begin() => (_states, _isUnderWay) = (new Dictionary<int, CommissioningState>(), true);

    /// <param name="step">From 0.</param>
    internal void Set(int step, CommissioningState state) => _states = new Dictionary<int, CommissioningState>(_states) { [step] = state };

    /// <summary>Ends the run; a step in progress becomes open again.</summary>
    internal void End() => (_states, _isUnderWay) = (_states.Where(step => step.Value != CommissioningState.Now).ToDictionary(), false);
}

/// <summary>A displayed step.</summary>
/// <param name="Number">From 1.</param>
public sealed record CommissioningStepView(int Number, string Name, CommissioningState State);

/// <summary>State of a step.</summary>
public enum CommissioningState
{
    /// <summary>Not started, or cancelled.</summary>
    Open,

    /// <summary>The step is asked about or in progress.</summary>
    Now,

    /// <summary>Completed; values answered with Enter are unchanged.</summary>
    Through,

    /// <summary>Skipped by the operator.</summary>
    LeftOut,

    /// <summary>Started but not completed: a move was stopped, refused or declined, or something has to be repaired first.</summary>
    Unfinished,
}
