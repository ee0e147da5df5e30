using Engraver.Samples.Dxf;

namespace Engraver.Samples.Drawings;

/// <summary>One file of the samples folder and how it is drawn.</summary>
internal sealed record Sample(string FileName, Func<DxfDocument> Draw, bool Binary = false)
{
    public static IReadOnlyList<Sample> All { get; } =
    [
        new("paper-001.dxf", PaperPart.Draw),
        new("nameplate.dxf", Nameplate.Draw),
        new("gasket.dxf", Gasket.Draw),
        new("nested-logo.dxf", NestedLogo.Draw),
        new("pcb-outline.dxf", PcbOutline.Draw),
        new("clock-dial.dxf", ClockDial.Draw, Binary: true),
        new("label-plate.dxf", LabelPlate.Draw),
        new("operation-plate.dxf", OperationPlate.Draw),
        new("finished-plate.dxf", FinishedPlate.Draw),
    ];

    /// <summary>Writes the file, over an earlier one of the same name.</summary>
    public void WriteTo(string folder)
    {
        using var file = File.Create(Path.Combine(folder, FileName));
        if (Binary)
        {
            using var sink = new BinaryTagSink(file, RealFormat.Trimmed);
            DxfWriter.Write(Draw(), sink);
        }
        else
        {
            using var sink = new AsciiTagSink(file, RealFormat.Trimmed);
            DxfWriter.Write(Draw(), sink);
        }
    }
}
