using Engraver.Core.Diagnostics;
using Engraver.Core.Posts;
using Engraver.Workbench.Playback;

namespace Engraver.Workbench.Stages;

/// <summary>A job with its posted program and its motion over time.</summary>
public sealed record PlannedJob : CheckedJob
{
    public PlannedJob(CheckedJob job)
        : base(job)
    {
    }

    /// <summary>The posted program of the machine's own controller, written on first access; null if there is nothing to cut.</summary>
    public Lazy<PostOutput?> Posted { get; init; } = new((PostOutput?)null);

    /// <summary>The motion over time; null if there is nothing to cut.</summary>
    public PlannedMotion? Planned { get; init; }

    /// <summary>Findings of the post.</summary>
    public IReadOnlyList<Diagnostic> PostFindings { get; init; } = [];
}
