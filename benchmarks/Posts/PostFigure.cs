using System.Globalization;
using Engraver.Workbench.Certificates;

namespace Engraver.Benchmarks.Posts;

/// <summary>The figures of one program, or of all programs of one target.</summary>
/// <param name="target">Including its dialect.</param>
/// <param name="drawing">Name of the drawing's file; null for all.</param>
internal sealed class PostFigure(string target, string? drawing = null)
{
    private readonly string _name = drawing is null ? target : $"{target} {drawing}";
    private readonly List<string> _failures = [];
    private int _programs;
    private int _unwritten;
    private long _lines;
    private long _bytes;
    private double _worst;
    private int _verified;
    private int _validCertificates;
    private double _posting;
    private double _verifying;
    private double _longest;

    /// <summary>A line for each written program without a valid certificate.</summary>
    public IReadOnlyList<string> Failures => _failures;

    /// <summary>A line for the program with the longest processor time to post or to verify.</summary>
    public string Slowest { get; private set; } = "";

    public void AddPosted(string? text, double seconds)
    {
        AddTime("post", seconds);
        _posting += seconds;
        if (text is null) _unwritten++;
        else (_programs, _lines, _bytes) = (_programs + 1, _lines + text.Count(sign => sign == '\n'), _bytes + text.Length);
    }

    public void AddCertified(JobCertificate certificate, CertificateStatus standing, bool isDamaged, double seconds)
    {
        AddTime("verify", seconds);
        _verifying += seconds;
        _worst = Math.Max(_worst, certificate.MaxDeviation ?? 0.0);
        if (certificate.Ok) _verified++;
        if (standing.State == CertificateState.Stands) _validCertificates++;
        else _failures.Add($"  {_name}: {(certificate.Ok ? $"certificate does not stand ({string.Join(", ", standing.Differences)})" : $"no certificate; {Reason(certificate, isDamaged)}")}");
    }

    /// <summary>Adds the figures of one program.</summary>
    public void Add(PostFigure one)
    {
        (_programs, _unwritten, _lines, _bytes) = (_programs + one._programs, _unwritten + one._unwritten, _lines + one._lines, _bytes + one._bytes);
        (_worst, _verified, _validCertificates) = (Math.Max(_worst, one._worst), _verified + one._verified, _validCertificates + one._validCertificates);
        (_posting, _verifying) = (_posting + one._posting, _verifying + one._verifying);
        _failures.AddRange(one._failures);
        if (one._longest > _longest) (_longest, Slowest) = (one._longest, one.Slowest);
    }

    public string ToMarkdown() => string.Create(CultureInfo.InvariantCulture, $"| {_name} | {_programs} | {_unwritten} | {_lines} | {_bytes} | {_worst:0.#####} | {_verified} | {_validCertificates} | {_posting:0.##} | {_verifying:0.##} |");

    private void AddTime(string work, double seconds)
    {
        if (seconds <= _longest) return;
        _longest = seconds;
        Slowest = string.Create(CultureInfo.InvariantCulture, $"  {target}: slowest {work} {drawing} {seconds:0.##} s");
    }

    private static string Reason(JobCertificate certificate, bool isDamaged) =>
        string.Create(CultureInfo.InvariantCulture, $"{(isDamaged ? "damaged drawing; " : "")}{(certificate.Findings.Count > 0 ? certificate.Findings[0].Sentence : "")} missing {certificate.MissingLength:0.####} extra {certificate.ExtraLength:0.####}");
}
