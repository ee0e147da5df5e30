namespace Engraver.Core.Dxf;

/// <summary>A layer of a written drawing.</summary>
/// <param name="Name">Written in ASCII; every other character is escaped.</param>
/// <param name="Colour">Colour index, 1 to 255.</param>
/// <param name="Plots">False for what is to be seen but not cut: our reader, like a plotter, leaves such a layer out unless it is asked for.</param>
public sealed record DxfSheetLayer(string Name, int Colour, bool Plots = true)
{
    public bool On { get; init; } = true;

    public bool Frozen { get; init; }

    /// <summary>True colour as 0x00RRGGBB, which stands above the index; null for none.</summary>
    public uint? Rgb { get; init; }
}
