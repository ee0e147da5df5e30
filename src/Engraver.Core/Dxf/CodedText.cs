namespace Engraver.Core.Dxf;

/// <summary>A text with its group code.</summary>
internal readonly record struct CodedText(int Code, string Value);
