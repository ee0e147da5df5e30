namespace Engraver.Workbench.Stages;

/// <summary>A job whose table is compensated for the tool radius, if the settings request it.</summary>
public record CompensatedJob : AssignedJob
{
    public CompensatedJob(AssignedJob job, CutTable cut)
        : base(job) => Cut = cut;

    /// <summary>The entities to cut.</summary>
    public CutTable Cut { get; init; }
}
