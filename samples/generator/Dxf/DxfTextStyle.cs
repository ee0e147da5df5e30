namespace Engraver.Samples.Dxf;

/// <summary>A text style and its font file.</summary>
internal sealed record DxfTextStyle(string Name, string FontFile);
