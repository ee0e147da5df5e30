namespace Engraver.Core.Diagnostics;

/// <summary>Findings before a job is run, when not everything visible is cut or it would be cut at another position. Lengths in the sentences are
/// millimetres.</summary>
public static class PreparationRules
{
    public static readonly DiagnosticRule NotCut = new("JOB0001", Severity.Warning, "counts");

    public static readonly DiagnosticRule NotLevel = new("JOB0002", Severity.Warning, "count", "low", "high");

    public static readonly DiagnosticRule SeveralHeights = new("JOB0003", Severity.Warning, "count", "low", "high");

    public static readonly DiagnosticRule OneHeight = new("JOB0004", Severity.Info, "z");

    public static readonly DiagnosticRule TooLarge = new("JOB0005", Severity.Warning, "width", "height", "distance", "size", "far", "guess");

    public static readonly DiagnosticRule NoOrigin = new("JOB0008", Severity.Error, "name", "position");

    public static readonly DiagnosticRule ZeroLost = new("JOB0009", Severity.Error, "name");

    public static readonly DiagnosticRule PositionDoubted = new("JOB0010", Severity.Error, "reason");

    public static readonly DiagnosticRule OriginHalfSet = new("JOB0011", Severity.Error, "name", "axis");

    public static readonly DiagnosticRule OriginTooFar = new("JOB0012", Severity.Error, "x", "y");

    public static readonly DiagnosticRule StateNotKept = new("JOB0013", Severity.Warning, "reason");

    public static readonly DiagnosticRule MotorUntold = new("JOB0014", Severity.Warning, "axes");

    public static readonly DiagnosticRule TraceNotKept = new("JOB0020", Severity.Warning, "reason");

    public static readonly DiagnosticRule ConversationNotKept = new("JOB0021", Severity.Warning, "reason");

    public static readonly DiagnosticRule OutsideTravel = new("JOB0030", Severity.Error, "axis", "place", "least", "most");

    public static readonly DiagnosticRule NotHomed = new("JOB0031", Severity.Error);

    public static readonly DiagnosticRule HeightNotSet = new("JOB0032", Severity.Error, "name");

    public static readonly DiagnosticRule HeightOutsideTravel = new("JOB0033", Severity.Error, "axis", "place", "least", "most");

    public static readonly DiagnosticRule DryRunOutsideTravel = new("JOB0034", Severity.Error, "lift", "axis", "place", "least", "most");

    public static readonly DiagnosticRule NotResumed = new("JOB0040", Severity.Error, "journal", "reason");

    public static readonly DiagnosticRule OtherProfile = new("JOB0041", Severity.Error);

    public static readonly DiagnosticRule SetByOtherCounts = new("JOB0042", Severity.Error, "name", "then", "axis", "now");

    public static readonly DiagnosticRule HomedByOtherCounts = new("JOB0043", Severity.Error, "then", "axis", "now");

    public static readonly DiagnosticRule NotSetWhileDoubted = new("JOB0044", Severity.Error, "reason");

    public static readonly DiagnosticRule StepBeyondTravel = new("JOB0045", Severity.Error, "step", "axis", "travel");

    public static readonly DiagnosticRule SetByOtherAxis = new("JOB0046", Severity.Error, "name", "axis", "then", "now");

    public static readonly DiagnosticRule NotSetWhileMoving = new("JOB0047", Severity.Error);

    public static readonly DiagnosticRule JournalUnsealed = new("JOB0048", Severity.Warning, "journal");

    public static readonly DiagnosticRule FamilyUntried = new("JOB0049", Severity.Warning, "model", "family");

    public static readonly DiagnosticRule JournalGivenUp = new("JOB0051", Severity.Warning, "reason");

    public static readonly DiagnosticRule SamePlace = new("JOB0052", Severity.Error, "name", "other");

    /// <summary>Every rule, for the documentation and its test.</summary>
    public static IReadOnlyList<DiagnosticRule> All { get; } = [NotCut, NotLevel, SeveralHeights, OneHeight, TooLarge, NoOrigin, ZeroLost, PositionDoubted, OriginHalfSet, OriginTooFar, StateNotKept, MotorUntold, TraceNotKept, ConversationNotKept, OutsideTravel, NotHomed, HeightNotSet, HeightOutsideTravel, DryRunOutsideTravel, NotResumed, OtherProfile, SetByOtherCounts, HomedByOtherCounts, NotSetWhileDoubted, StepBeyondTravel, SetByOtherAxis, NotSetWhileMoving, JournalUnsealed, FamilyUntried, JournalGivenUp, SamePlace];
}
