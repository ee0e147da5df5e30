using System.Globalization;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Dxf;
using Engraver.Core.Dxf.Writing;
using Engraver.Workbench.CommandLanguage;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Files;
using Engraver.Workbench.Sidecars;

namespace Engraver.Workbench.Commands.Files;

/// <summary>Writes a drawing and its sidecar for SAVEAS and QSAVE, and reads the sidecar for OPEN.</summary>
internal static class DrawingSaving
{
    /// <summary>Warns about content of the drawing's file that the new file will not contain.</summary>
    public static void WarnLostContent(CommandContext context)
    {
        var drawing = context.Drawing;
        if (UnusedContent.Find(drawing) is not { Count: > 0 } rest) return;
        var types = string.Join(", ", rest.Select(part => FormattableString.Invariant($"{part.Count} {part.Type}")));
        FindingMessages.Write(context, drawing.FileName, [DocumentRules.NotSaved.At(default, rest.Sum(part => part.Count).ToString(CultureInfo.InvariantCulture), types)], Severity.Warning);
    }

    /// <param name="name">As typed.</param>
    public static void WriteDrawing(CommandContext context, string name, string path)
    {
        var drawing = context.Drawing;
        var sheet = EditedDrawing.SheetOf(drawing, context.Document.Current.HiddenObjects);
        OutputFile.Write(path, output => DxfWriter.Write(sheet, output));
        context.Document.MarkHandles(path, EditedDrawing.HandlesIn(sheet, drawing));
        context.WriteMessage(Wording.Get("SaveAs.Written", name, CountText.Format(sheet.Entities.Count, "Curve"), sheet.Points.Count > 0 ? $"{CountText.Format(sheet.Texts.Count, "Text")}, {CountText.Format(sheet.Points.Count, "PointObject")}" : CountText.Format(sheet.Texts.Count, "Text"), CountText.Format(sheet.Layers.Count, "Layer"), drawing.Unit.Name));
        if (drawing.Placement.IsNone) return;
        context.Document.MarkPlacementSaved();
        context.WriteMessage(Wording.Get("DrawingSaving.PlacementSaved"));
    }

    /// <summary>Writes the sidecar of a drawing file. An existing sidecar that this session neither read nor wrote is renamed.</summary>
    /// <param name="drawing">Path of the drawing's file.</param>
    /// <returns>False if there was nothing to write.</returns>
    public static bool WriteSidecar(CommandContext context, string drawing)
    {
        var (sidecar, path) = (context.Document.Current.Sidecar, SidecarFile.PathOf(drawing));
        if (FileKind.IsStream(drawing)) return false;
        var known = context.Document.KnownSidecar(path);
        if (sidecar.IsEmpty && (known is null || !File.Exists(path))) return false;
        var text = SidecarText.Write(WithHandlesOf(sidecar, context.Document.HandlesIn(drawing)), Path.GetFileName(drawing), SidecarFile.FingerprintOf(context.Drawing));
        if (SidecarFile.Write(path, text, known, context.Time) is { } aside) FindingMessages.Write(context, drawing, [SidecarRules.SetAside.At(default, Path.GetFileName(path), Path.GetFileName(aside))], Severity.Warning);
        context.Document.MarkSidecar(path, text);
        var trajectories = CountText.Format(sidecar.Trajectories.All.Count, "Trajectory");
        context.WriteMessage(sidecar.Operations is { } plan ? Wording.Get("DrawingSaving.SidecarOperations", Path.GetFileName(path), trajectories, plan.Operations.Count) : Wording.Get("DrawingSaving.Sidecar", Path.GetFileName(path), trajectories));
        return true;
    }

    /// <summary>Entities get new handles in a written drawing; trajectories and operations refer to these.</summary>
    private static Sidecar WithHandlesOf(Sidecar sidecar, IReadOnlyDictionary<string, IReadOnlyList<string>> written)
    {
        if (written.Count == 0) return sidecar;
        var list = sidecar.Trajectories;
        return sidecar with { Operations = sidecar.Operations?.WithHandles(handle => written.GetValueOrDefault(handle, [])), Trajectories = list with { All = [.. list.All.Select(one => one with { Handles = [.. one.Handles.SelectMany(handle => written.GetValueOrDefault(handle, [])).Distinct()] })] } };
    }

    /// <summary>The sidecar of a drawing; without one, trajectory settings of the previous drawing are kept.</summary>
    public static Sidecar LoadSidecar(CommandContext context, Drawing drawing)
    {
        var read = SidecarFile.Read(drawing);
        FindingMessages.Write(context, drawing.FileName, read.Findings, Severity.Warning);
        if (read.Text is { } text) context.Document.MarkSidecar(SidecarFile.PathOf(drawing.FileName), text);
        return read.Sidecar ?? WithSettingsOf(context.Document.Current.Sidecar);
    }

    /// <summary>Only the settings.</summary>
    public static Sidecar WithSettingsOf(Sidecar sidecar) => new() { Trajectories = new TrajectoryList { Settings = sidecar.Trajectories.Settings } };
}
