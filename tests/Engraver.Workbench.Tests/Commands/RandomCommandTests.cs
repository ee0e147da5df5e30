using Engraver.TestKit;
using Engraver.Workbench.Commands;
using FsCheck;
using FsCheck.Fluent;
using FsCheck.Xunit;

namespace Engraver.Workbench.Tests.Commands;

/// <summary>Random command sequences, which no operator would type.</summary>
public class RandomCommandTests
{
    /// <summary>Whole edits, each a sequence of inputs that an operator could type.</summary>
    private static readonly string[][] s_edits =
    [
        ["MOVE", "ALL", "", "0,0", "1.5,0.25"], ["MOVE", "L", "", "D", "@3,4"], ["ROTATE", "ALL", "", "5,5", "33.3"], ["RO", "L", "", "0,0", "C", "-90"], ["SCALE", "ALL", "", "1,1", "R", "3", "2"],
        ["MI", "ALL", "", "0,0", "1,3", "Y"], ["MI", "L", "", "0,0", "0,1", ""], ["ERASE", "L", ""], ["REVERSE", "ALL", ""], ["E", "C", "4,4", "6,11", ""], ["LA", "OFF", "*", ""], ["LA", "ON", "*", "Freeze", "0", "T", "0", ""],
        ["ENTER", "N"], ["ENTER", "P", "3,3"], ["ENTER", "H", "A1"], ["CNCORDER", "D"], ["CNCMAXERR", "0.01"], ["CNCJOINTOL", ""], ["TOOLSTART", "7,8"], ["AUTOSEQUENCE"], ["CLOSE"], ["SELECT", "ALL", ""], ["SELECT", "W", "-1,-1", "11,1", ""],
        ["L", "0,0", "5,5", "@3,0", "U", "9,9", ""], ["L", "", "1,7"], ["PL", "0,0", "5,0", "A", "5,5", "CL"], ["PL", "0,0", "5,0", "U"], ["C", "5,5", "3"], ["A", "0,0", "1,1", "2,0"], ["REC", "0,0", "5,5"], ["POL", "5", "0,0", "I", "4"], ["EL", "0,0", "9,0", "2"], ["NEW"],
    ];

    private static readonly Arbitrary<string[][]> s_sessions = Gen.Elements(s_edits).ToArrays(size: 12);

    private static readonly Arbitrary<string[]> s_noise = Gen.Frequency(
        (3, Gen.Elements(CommandCatalog.Built().All.Select(info => info.Name).Where(name => name is not ("CNCRUN" or "CNCSIM")).ToArray())),
        (3, Gen.Elements("", "ALL", "L", "P", "W", "C", "R", "A", "U", "H", "LA", "?", "Yes", "N", "Copy", "sim:", "A1", "0", "*", "\u001b")),
        (3, Gen.Elements("0,0", "5,5", "@3,4", "10<45", "@", "#1,2", "1e99,1e99", "-3,2", "0.5", "2", "-1", "1e300", "nan")),
        (1, Gen.Elements("'ID", "'DIST", "'MOVE", "'", "'HELP", "tcp://", "serial://x", "no such file.dxf", ";", "\"", "_m", "%s{0}"))).ToArrays(size: 40);

    [Property]
    public Property Undo_brings_back_every_earlier_state_exactly_and_redo_does_it_again() => Prop.ForAll(s_sessions, HoldsAsync);

    [Property]
    public Property No_sequence_of_inputs_breaks_the_session() => Prop.ForAll(s_noise, SurvivesAsync);

    private static async Task<bool> HoldsAsync(string[][] edits)
    {
        await using var talk = CommandTestSession.WithDrawing();
        var document = talk.Session.Document;
        List<string> prints = [Fingerprint.Of(document.Current)];
        var steps = document.UndoNames.Count();
        foreach (var edit in edits)
        {
            if (document.Current.Drawing is null) break; // The words of a failed edit would be separate commands.
            await talk.TypeAsync(edit);
            await talk.Session.CancelAsync();
            if (document.UndoNames.Count() > steps) prints.Add("");
            steps = document.UndoNames.Count();
            prints[^1] = Fingerprint.Of(document.Current);
        }

        for (var step = prints.Count - 2; step >= 0; step--)
        {
            await talk.TypeAsync("U");
            if (Fingerprint.Of(document.Current) != prints[step]) return false;
        }

        for (var step = 1; step < prints.Count; step++)
        {
            await talk.TypeAsync("REDO");
            if (Fingerprint.Of(document.Current) != prints[step]) return false;
        }

        return true;
    }

    private static async Task<bool> SurvivesAsync(string[] inputs)
    {
        await using var talk = CommandTestSession.WithDrawing();
        foreach (var input in inputs)
        {
            if (input == "\u001b")
            {
                await talk.Session.CancelAsync();
                if (talk.Session.Prompt != PromptView.Idle) return false;
                continue;
            }

            var result = await talk.TypeAsync(input);
            var asks = talk.Session.Prompt.Command is not null;
            if (talk.Session.IsBusy || (result is InputResult.AwaitingInput && !asks) || !IsConsistent(talk)) return false;
        }

        return true;
    }

    private static bool IsConsistent(CommandTestSession talk)
    {
        var count = talk.State.Drawing?.Entities.Count ?? 0;
        return talk.State.Selection.Concat(talk.State.Previous).All(entity => entity >= 0 && entity < count);
    }
}
