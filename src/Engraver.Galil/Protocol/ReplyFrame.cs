namespace Engraver.Galil.Protocol;

/// <summary>One prompt and the bytes before it; a character of <paramref name="Data"/> is one byte.</summary>
public readonly record struct ReplyFrame(bool Accepted, string Data);
