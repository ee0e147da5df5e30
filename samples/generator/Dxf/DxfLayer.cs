namespace Engraver.Samples.Dxf;

/// <summary>A row of the LAYER table; <paramref name="Colour"/> is the AutoCAD colour index.</summary>
internal sealed record DxfLayer(string Name, int Colour, bool Off = false, bool Frozen = false, bool Plots = true);
