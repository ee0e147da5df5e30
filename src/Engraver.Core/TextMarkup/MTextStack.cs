namespace Engraver.Core.TextMarkup;

/// <summary>Two texts above each other (\S).</summary>
/// <param name="Upper">Its characters; may be empty.</param>
/// <param name="Lower">Its characters; may be empty.</param>
/// <param name="Kind">What is between them.</param>
public sealed record MTextStack(string Upper, string Lower, MTextStackKind Kind);
