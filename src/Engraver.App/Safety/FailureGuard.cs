using Engraver.App.Texts;
using Engraver.Workbench.Machines.Alarms;
using Engraver.Workbench.Reports;

namespace Engraver.App.Safety;

/// <summary>Handles a failure of the program outside the commands: stops the machine first, then writes a report and raises an alarm. It never
/// throws.</summary>
/// <param name="stop">Stops the machine; from any thread, does not wait.</param>
public sealed class FailureGuard(Action stop, AlarmLog alarms, FailureReports reports)
{
    /// <summary>Handles an unexpected exception; from any thread.</summary>
    /// <returns>The path of the report; null if none was written.</returns>
    public string? Handle(Exception failure)
    {
        ArgumentNullException.ThrowIfNull(failure);
        stop();
        var file = reports.Write(failure);
        alarms.Raise(AlarmCause.InternalError, Text.Get("Failure.InternalError", failure.Message.TrimEnd('.')), Text.Get("Failure.ThisProgram"), file is null ? Text.Get("Failure.Advice") : Text.Get("Failure.AdviceWithReport", file));
        return file;
    }
}
