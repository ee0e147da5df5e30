namespace Engraver.Core.SecondOpinions;

/// <summary>A group code, and where in the file its value stands.</summary>
internal readonly record struct SecondTag(int Code, int Start, int Length);
