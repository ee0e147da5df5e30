using System.Globalization;
using System.Text;
using Engraver.Core.Machines;

namespace Engraver.Galil.Language;

/// <summary>The controller's letters of its axes (galil-dmc.md B.1). The profile states which of them a job moves (<see cref="MachineAxes"/>).</summary>
public static class DmcAxes
{
    /// <summary>All axis letters; a controller with four axes has the first four.</summary>
    public const string All = "ABCDEFGH";

    /// <summary>True when the first fields of a list from axis A are the job's axes in their order, as LI needs (galil-dmc.md B.1: <c>LI a,b,c,d</c>). VP uses
    /// the order of VM.</summary>
    public static bool AreLeading(MachineAxes axes) => All.StartsWith(axes.PlaneLetters, StringComparison.Ordinal);

    /// <summary>Values of the job's axes in the fields of a list from axis A (<c>1,2,,3</c>), as LI needs them independent of the order of LM (galil-dmc.md
    /// B.1, L.2 8).</summary>
    public static string Fields(MachineAxes axes, ReadOnlySpan<string> values)
    {
        var fields = new string[axes.All.Max(axis => All.IndexOf(axis.Letter)) + 1];
        for (var i = 0; i < values.Length; i++) fields[All.IndexOf(axes.All[i].Letter)] = values[i];
        return string.Join(',', fields);
    }

    /// <summary>The command with which the controller counts an axis as being at a place, with its line end.</summary>
    public static byte[] Placing(char axis, long place) => Encoding.ASCII.GetBytes(string.Create(CultureInfo.InvariantCulture, $"DP{axis}={place}\r"));

    /// <summary>An operand for each axis, separated by commas: <c>_RPA,_RPB</c>.</summary>
    /// <param name="operand">Operand without the axis letter.</param>
    public static string Operands(string letters, string operand) => string.Join(',', letters.Select(letter => operand + letter));
}
