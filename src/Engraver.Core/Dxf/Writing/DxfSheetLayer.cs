namespace Engraver.Core.Dxf.Writing;

/// <summary>A layer of a written drawing.</summary>
/// <param name="Name">Written in ASCII; every other character is escaped.</param>
/// <param name="Colour">Colour index, 1 to 255.</param>
/// <param name="Plots">False for a layer that is shown but not cut: the reader of this package, like a plotter, leaves it out unless it is selected.</param>
public sealed record DxfSheetLayer(string Name, int Colour, bool Plots = true)
{
    public bool On { get; init; } = true;

    public bool Frozen { get; init; }

    /// <summary>Its objects cannot be changed.</summary>
    public bool Locked { get; init; }

    /// <summary>Group 370.</summary>
    public int Lineweight { get; init; } = Drawings.Lineweight.Default;

    public string Linetype { get; init; } = "Continuous";

    /// <summary>True colour as 0x00RRGGBB, which has precedence over the index; null for none.</summary>
    public uint? Rgb { get; init; }
}
