using Engraver.App.Canvas;
using Engraver.App.Texts;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;

namespace Engraver.App.Desk;

/// <summary>Creates the mark of the machine position: in drawing coordinates by the work origin, or in machine coordinates with a note if the origin is
/// unknown.</summary>
internal static class MachineMarkBuilder
{
    /// <returns>Null while no controller is connected or no position has been reported.</returns>
    public static MachineMark? Of(MachineSession machine, DocumentState state)
    {
        var status = machine.Status;
        if (machine.Connection.Description is null || status.MachinePosition is not { } at) return null;
        var inDrawing = machine.Origins.PlaceInDrawing;
        return new MachineMark(at, machine.Trail.Places, at - (inDrawing ?? at), state.Scale, NoteOf(status, inDrawing is not null));
    }

    private static string NoteOf(MachineStatus status, bool isKnown)
    {
        if (status.IsLinkLost) return Text.Get("Canvas.MachineLinkLost");
        if (isKnown) return "";
        return Text.Get(status.IsHomed == false ? "Canvas.MachineNotHomed" : "Canvas.MachineNoOrigin");
    }
}
