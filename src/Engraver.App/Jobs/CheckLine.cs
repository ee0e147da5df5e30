using Engraver.App.Texts;
using Engraver.Workbench.Machines;

namespace Engraver.App.Jobs;

/// <summary>One thing that must be so before a job may start, or that the operator must have read.</summary>
public sealed record CheckLine(ArmingCheck Check)
{
    /// <summary>Shape besides colour.</summary>
    public string Mark => Check switch { { Passed: false } => "✗", { IsWarning: true } => "▲", _ => "✓" };

    /// <summary>A warning says by a word, too, that it is one.</summary>
    public string Sentence => Check.IsWarning ? Text.Of("Job.Look", Check.Sentence) : Check.Sentence;

    /// <summary>It is not so, or it wants to be read.</summary>
    public bool IsUnusual => !Check.Passed || Check.IsWarning;
}
