using Engraver.Core;
using Engraver.Core.Diagnostics;
using Engraver.Core.Machines;
using Engraver.Galil.Language;
using Engraver.Galil.Programs.Posting;
using Engraver.Galil.Protocol;
using Engraver.Galil.Sessions;

namespace Engraver.Galil.Driver;

/// <summary>Runs one program of a posted file in a controller: downloads and starts it, and afterwards queries which line was refused.</summary>
public static class ReadBackRun
{
    /// <summary>Sets the motor types of the profile in the controller, because a program only tests them. Call once, before the first chunk.</summary>
    public static async Task SetMotorsAsync(MachineProfile profile, CommandChannel channel, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(profile);
        ArgumentNullException.ThrowIfNull(channel);
        foreach (var axis in profile.Axes.All)
        {
            if (axis.MotorType is not { } type) continue;
            foreach (var command in (string[])[$"MO{axis.Letter}", $"MT{axis.Letter}={DmcFormat.Number(type)}"]) await channel.SendAsync(command, cancellation).ConfigureAwait(false);
        }
    }

    /// <summary>Downloads the chunk and starts it at #JOB.</summary>
    /// <returns>The reason why it was not started; null when it was.</returns>
    public static async Task<Diagnostic?> StartAsync(ReadBackChunk chunk, CommandChannel channel, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(chunk);
        ArgumentNullException.ThrowIfNull(channel);
        var start = new SourceRef(chunk.FirstLine);
        if (await channel.DownloadAsync(chunk.Text, cancellation).ConfigureAwait(false) is Rejected unloaded) return VerificationRules.NotLoaded.At(start, NumberText.Whole((int)unloaded.Code), unloaded.Text);
        return await channel.SendAsync("XQ#JOB", cancellation).ConfigureAwait(false) is Rejected unstarted ? VerificationRules.NotLoaded.At(start, NumberText.Whole((int)unstarted.Code), unstarted.Text) : null;
    }

    /// <summary>The line that the controller refused while the chunk ran; null for none. _ED1 is -1 while no line was refused; _ED counts lines from
    /// 0.</summary>
    public static async Task<Diagnostic?> ErrorAsync(ReadBackChunk chunk, CommandChannel channel, CancellationToken cancellation)
    {
        ArgumentNullException.ThrowIfNull(chunk);
        ArgumentNullException.ThrowIfNull(channel);
        var reading = await channel.ReadAsync("_ED,_ED1,_TC", cancellation).ConfigureAwait(false);
        var (line, thread, code) = ((int)reading.Values[0], (int)reading.Values[1], (TcCode)reading.Values[2]);
        if (thread < 0) return null;
        var text = line < chunk.Lines.Count ? chunk.Lines[line] : Wording.Get("ReadBackRun.AfterLastLine");
        return VerificationRules.LineRefused.At(new SourceRef(chunk.FirstLine + Math.Min(line, chunk.Lines.Count - 1)), text, NumberText.Whole((int)code), TcCodes.Text(code));
    }
}
