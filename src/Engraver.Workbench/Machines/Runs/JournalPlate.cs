using Engraver.Workbench.Composition;
using Engraver.Workbench.SerialTexts;

namespace Engraver.Workbench.Machines.Runs;

/// <summary>The plate in the journal of a run.</summary>
public static class JournalPlate
{
    /// <returns>Null if the run was not one of a plate, or the journal cannot be read; resuming it then reports why.</returns>
    public static Plate? Read(string journal)
    {
        try
        {
            return JournalledRun.Read(journal)?.Settings?.GetValueOrDefault(JournalSettings.PlateKey) is { } text ? Plate.FromJson(text) : null;
        }
        catch (FormatException)
        {
            return null;
        }
    }
}
