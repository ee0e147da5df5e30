namespace Engraver.Core.Verification;

/// <summary>Conditions of a run at one place.</summary>
/// <param name="FeedRatio">Factor of the programmed feed in effect; null when not recorded.</param>
/// <param name="LinkLoad">Part of the time in which the command handle was busy with an exchange, 0 to 1; null when not recorded.</param>
public readonly record struct TraceConditions(double? FeedRatio, double? LinkLoad);
