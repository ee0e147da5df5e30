using System.Globalization;
using System.Text.Json;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Languages;
using Engraver.Core.Verification;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Sidecars;

/// <summary>The file beside a drawing: read whole or not at all, written whole or not at all.</summary>
public static class SidecarFile
{
    /// <summary><c>NAME.dxf.engraver.json</c>.</summary>
    public static string PathOf(string drawing) => drawing + ".engraver.json";

    /// <summary>Fingerprint of all curves of a drawing, hidden ones too.</summary>
    public static string FingerprintOf(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return DrawnFingerprint.Of([.. Enumerable.Range(0, drawing.Parts.Count).Select(part => drawing.SegmentOf(drawing.Parts[part]))]);
    }

    /// <summary>What stands beside a drawing's file. A file that cannot be used stays as it is.</summary>
    public static SidecarReading Read(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        var path = PathOf(drawing.FileName);
        var name = Path.GetFileName(path);
        try
        {
            if (!File.Exists(path)) return new SidecarReading(null, null, []);
            var text = File.ReadAllText(path);
            var (sidecar, fingerprint) = SidecarText.Read(text);
            return new SidecarReading(sidecar, text, fingerprint is null || fingerprint == FingerprintOf(drawing) ? [] : [SidecarRules.DrawingChanged.At(default, name)]);
        }
        catch (JsonException damaged)
        {
            return new SidecarReading(null, null, [SidecarRules.Damaged.At(default, name, SystemReason.Of(damaged))]);
        }
        catch (SidecarVersionException other)
        {
            return new SidecarReading(null, null, [SidecarRules.OtherVersion.At(default, name, other.Message)]);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return new SidecarReading(null, null, [SidecarRules.Unreadable.At(default, name, SystemReason.Of(unreadable))]);
        }
    }

    /// <param name="known">What the writer believes to stand there; null for nothing.</param>
    /// <returns>Where another file that stood there is kept now; null when none did.</returns>
    /// <exception cref="IOException">The place cannot be written; what was there is still there.</exception>
    /// <exception cref="UnauthorizedAccessException">The same.</exception>
    public static string? Write(string path, string text, string? known, TimeProvider time)
    {
        ArgumentNullException.ThrowIfNull(time);
        string? aside = null;
        if (File.Exists(path) && File.ReadAllText(path) != known)
        {
            aside = string.Create(CultureInfo.InvariantCulture, $"{path}.kept-{time.GetUtcNow():yyyyMMdd-HHmmss-fff}");
            File.Copy(path, aside);
        }

        OutputFile.Write(path, output => output.Write(text));
        return aside;
    }
}

/// <summary>What stood beside a drawing.</summary>
/// <param name="Sidecar">Null when there is no file, or none that can be used.</param>
/// <param name="Text">Of the file that was used.</param>
/// <param name="Findings">Why it is not used, or doubtful.</param>
public sealed record SidecarReading(Sidecar? Sidecar, string? Text, IReadOnlyList<Diagnostic> Findings);
