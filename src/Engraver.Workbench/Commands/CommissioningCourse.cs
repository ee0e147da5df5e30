namespace Engraver.Workbench.Commands;

/// <summary>The steps of CNCCOMMISSION and how far the last one has come, for a page that shows them. Any thread.</summary>
/// <param name="names">What each step finds out, in the language of now.</param>
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

    /// <summary>It ended, whichever way; a step that was under way is open again.</summary>
    internal void End() => (_states, _isUnderWay) = (_states.Where(step => step.Value != CommissioningState.Now).ToDictionary(), false);
}

/// <summary>A step as it is shown.</summary>
/// <param name="Number">From 1.</param>
public sealed record CommissioningStepView(int Number, string Name, CommissioningState State);

/// <summary>Where a step stands.</summary>
public enum CommissioningState
{
    /// <summary>Not asked yet, or broken off.</summary>
    Open,

    /// <summary>Its question is asked, or it is under way.</summary>
    Now,

    /// <summary>Gone through to its end; what was answered with Enter stays as it was found.</summary>
    Through,

    /// <summary>The operator left it out.</summary>
    LeftOut,

    /// <summary>Begun, and left before its end: a move was stopped, refused or not wanted, or something has to be mended first.</summary>
    Unfinished,
}
