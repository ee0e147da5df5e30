namespace Engraver.Core.SecondOpinions;

/// <summary>A group code and its value as text.</summary>
internal readonly record struct SecondTag(int Code, string Value);
