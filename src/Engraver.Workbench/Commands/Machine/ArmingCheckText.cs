using Engraver.Workbench.Machines.Arming;

namespace Engraver.Workbench.Commands.Machine;

/// <summary>Writes the start checks line by line.</summary>
internal static class ArmingCheckText
{
    public static void Write(CommandContext context, ArmingCheck check) =>
        context.WriteMessage(check.Line, check switch { { IsWarning: true } => MessageKind.Warning, { Passed: true } => MessageKind.Result, _ => MessageKind.Error });
}
