using Engraver.App.Canvas;
using Engraver.App.Texts;
using Engraver.Workbench.Documents;
using Engraver.Workbench.Machines;

namespace Engraver.App.Desk;

/// <summary>Makes the mark of the machine's place: in the drawing, as the work origin says, or by the machine's own zero with a note where nobody knows
/// where the drawing lies.</summary>
internal static class MachineMarks
{
    /// <returns>Null while no controller is connected or it has not told its place.</returns>
    public static MachineMark? Of(MachineSession machine, DocumentState state)
    {
        var status = machine.Status;
        if (machine.Description is null || status.MachinePosition is not { } at) return null;
        var inDrawing = machine.PlaceInDrawing;
        return new MachineMark(at, machine.Trail.Places, at - (inDrawing ?? at), state.Scale, NoteOf(status, inDrawing is not null));
    }

    private static string NoteOf(MachineStatus status, bool isKnown)
    {
        if (status.IsLinkLost) return Text.Get("Canvas.MachineLinkLost");
        if (isKnown) return "";
        return Text.Get(status.IsHomed == false ? "Canvas.MachineNotHomed" : "Canvas.MachineNoOrigin");
    }
}
