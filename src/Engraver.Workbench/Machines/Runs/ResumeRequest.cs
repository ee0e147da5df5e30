namespace Engraver.Workbench.Machines.Runs;

/// <summary>A job that starts in the middle: where an earlier one ended according to its journal, or from a chosen contour.</summary>
public sealed record ResumeRequest
{
    /// <summary>The default of <see cref="LeadInMm"/>.</summary>
    public const double DefaultLeadInMm = 1.0;

    /// <summary>The maximum of <see cref="LeadInMm"/>.</summary>
    public const double MaxLeadInMm = 1000.0;

    /// <summary>Journal of the interrupted job; null where <see cref="Stroke"/> was chosen.</summary>
    public string? Journal { get; init; }

    /// <summary>Index of the first contour to cut, from 0 in the order of cutting; used without a journal.</summary>
    public int Stroke { get; init; }

    /// <summary>Length of the path before the resume position that is cut again, millimetres.</summary>
    public double LeadInMm { get; init; } = DefaultLeadInMm;

    /// <summary>The job resumes at the active work origin although it was started at another one: the operator has set the origin again at the same point of
    /// the work.</summary>
    public bool AtOrigin { get; init; }
}
