using System.Globalization;
using Engraver.App.Texts;
using Engraver.Workbench.Machines;

namespace Engraver.App.Safety;

/// <summary>What happens when the program itself fails: the machine is stopped first, then a report is written and an alarm raised. It never throws.</summary>
/// <param name="stop">Stops the machine; from any thread, waits for nothing.</param>
/// <param name="folder">Where the reports are kept.</param>
public sealed class FailureGuard(Action stop, AlarmLog alarms, string folder, TimeProvider time)
{
    /// <summary>What fails again and again fills no disk.</summary>
    private const int MostReports = 20;

    private int _reports;

    /// <summary>Takes what nobody expected; from any thread.</summary>
    /// <returns>The file of the report; null when none was written.</returns>
    public string? Take(Exception failure)
    {
        ArgumentNullException.ThrowIfNull(failure);
        stop();
        var file = Write(failure);
        alarms.Raise(AlarmCause.ProgramFailed, Text.Of("Failure.What", failure.Message.TrimEnd('.')), Text.Of("Failure.Where"), file is null ? Text.Of("Failure.ToDo") : Text.Of("Failure.ToDoWithReport", file));
        return file;
    }

    private string? Write(Exception failure)
    {
        var number = Interlocked.Increment(ref _reports);
        if (number > MostReports) return null;
        var now = time.GetUtcNow();
        var file = Path.Combine(folder, string.Create(CultureInfo.InvariantCulture, $"crash-{now:yyyyMMdd-HHmmss}-{number}.txt"));
        try
        {
            Directory.CreateDirectory(folder);
            File.WriteAllText(file, string.Create(CultureInfo.InvariantCulture, $"{now:O}\n{typeof(FailureGuard).Assembly.GetName()}\n{Environment.OSVersion}, .NET {Environment.Version}\n\n{failure}\n"));
            return file;
        }
        catch (Exception unwritable) when (unwritable is IOException or UnauthorizedAccessException)
        {
            return null; // the alarm says what happened all the same
        }
    }
}
