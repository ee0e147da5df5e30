namespace Engraver.Workbench.Commands;

/// <summary>The steps of CNCCOMMISSION and the state of the last run, for display. Any thread.</summary>
/// <param name="names">The names of the steps in the current language.</param>
public sealed class CommissioningProgress(Func<IReadOnlyList<string>> names)
{
    private volatile IReadOnlyDictionary<int, CommissioningState> _states = new Dictionary<int, CommissioningState>();
    private volatile bool _isRunning;

    /// <summary>True from the first question to the last.</summary>
    public bool IsRunning => _isRunning;

    public IReadOnlyList<CommissioningStepView> Steps => [.. names().Select((name, i) => new CommissioningStepView(i + 1, name, _states.GetValueOrDefault(i)))];

    internal void Start() => (_states, _isRunning) = (new Dictionary<int, CommissioningState>(), true);

    /// <param name="step">From 0.</param>
    internal void Set(int step, CommissioningState state) => _states = new Dictionary<int, CommissioningState>(_states) { [step] = state };

    /// <summary>Ends the run; a step in progress becomes open again.</summary>
    internal void End() => (_states, _isRunning) = (_states.Where(step => step.Value != CommissioningState.InProgress).ToDictionary(), false);
}
