using System.Globalization;
using System.Text.Json;
using Engraver.Core.Diagnostics;
using Engraver.Core.Drawings;
using Engraver.Core.Languages;
using Engraver.Core.Verification;
using Engraver.Workbench.Files;

namespace Engraver.Workbench.Sidecars;

/// <summary>The sidecar file of a drawing: read and written completely or not at all.</summary>
public static class SidecarFile
{
    /// <summary><c>NAME.dxf.engraver.json</c>.</summary>
    public static string PathOf(string drawing) => drawing + ".engraver.json";

    /// <summary>Fingerprint of all curves of a drawing, including hidden ones.</summary>
    public static string FingerprintOf(Drawing drawing)
    {
        ArgumentNullException.ThrowIfNull(drawing);
        return DrawnFingerprint.Of([.. Enumerable.Range(0, drawing.Parts.Count).Select(part => drawing.SegmentOf(drawing.Parts[part]))]);
    }

    /// <summary>Reads the sidecar of a drawing's file. An unusable file is not changed.</summary>
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
            List<Diagnostic> findings = fingerprint is null || fingerprint == FingerprintOf(drawing) ? [] : [SidecarRules.DrawingChanged.At(default, name)];
            if (sidecar.WhyNotRun is { } why) findings.Add(SidecarRules.OperationsNotRun.At(default, name, why.TrimEnd('.')));
            return new SidecarReading(sidecar, text, findings);
        }
        catch (JsonException damaged)
        {
            return new SidecarReading(null, null, [SidecarRules.Damaged.At(default, name, SystemErrorText.FromException(damaged))]);
        }
        catch (SidecarVersionException other)
        {
            return new SidecarReading(null, null, [SidecarRules.OtherVersion.At(default, name, other.Message)]);
        }
        catch (Exception unreadable) when (unreadable is IOException or UnauthorizedAccessException)
        {
            return new SidecarReading(null, null, [SidecarRules.Unreadable.At(default, name, SystemErrorText.FromException(unreadable))]);
        }
    }

    /// <param name="known">The expected current text; null for no file.</param>
    /// <returns>New path of a different file that existed there; null if there was none.</returns>
    /// <exception cref="IOException">The path cannot be written; the old file is unchanged.</exception>
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

/// <summary>Result of reading a sidecar.</summary>
/// <param name="Sidecar">Null if there is no usable file.</param>
/// <param name="Text">Text of the used file.</param>
/// <param name="Findings">Why it is not used or doubtful.</param>
public sealed record SidecarReading(Sidecar? Sidecar, string? Text, IReadOnlyList<Diagnostic> Findings);
