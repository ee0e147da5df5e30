using System.Globalization;
using System.Xml;
using Engraver.Core.Languages;

namespace Engraver.Workbench.Reports.Pages;

/// <summary>Writes a page that is both HTML and well-formed XML. All text is escaped, except pictures, which escape their own text.</summary>
internal sealed class PageWriter : IDisposable
{
    private const string Html = "http://www.w3.org/1999/xhtml";

    private readonly TextWriter _output;
    private readonly XmlWriter _xml;

    public PageWriter(TextWriter output) => (_output, _xml) = (output, XmlWriter.Create(output, new XmlWriterSettings { OmitXmlDeclaration = true, NewLineChars = "\n", NewLineHandling = NewLineHandling.None }));

    /// <summary>Writes the start of the page. Its policy allows no external resources and no scripts.</summary>
    public void Begin(string title)
    {
        _xml.WriteDocType("html", null, null, null);
        _xml.WriteStartElement("html", Html);
        _xml.WriteAttributeString("lang", LanguageFile.For(CultureInfo.CurrentUICulture)?.Code ?? "en");
        _xml.WriteStartElement("head");
        Meta(("charset", "utf-8"));
        Meta(("http-equiv", "Content-Security-Policy"), ("content", "default-src 'none'; style-src 'unsafe-inline'"));
        Meta(("name", "viewport"), ("content", "width=device-width"));
        Element("title", title);
        _xml.WriteStartElement("style");
        _xml.WriteRaw(Style());
        End();
        End();
        _xml.WriteStartElement("body");
        Element("h1", title);
    }

    /// <summary>Ends the body and the page.</summary>
    public void Finish()
    {
        End();
        _xml.WriteFullEndElement();
        _xml.Flush();
    }

    /// <param name="key">Name of the section for programs that read the page.</param>
    public void Section(string key, string heading, Action write)
    {
        _xml.WriteStartElement("section");
        _xml.WriteAttributeString("id", key);
        Element("h2", heading);
        write();
        End();
    }

    public void Paragraph(string text, string style = "") => Element("p", text, style);

    /// <summary>An element with content written by the caller.</summary>
    public void Figure(string style, Action<TextWriter> picture)
    {
        Begin("figure", style);
        _xml.WriteString("\n");
        _xml.Flush();
        picture(_output);
        End();
    }

    public void Inside(string style, Action write)
    {
        Begin("div", style);
        write();
        End();
    }

    /// <summary>A table of names and values. The exact value is in <c>data-value</c>, with its name in the JSON of the console.</summary>
    public void Pairs(IEnumerable<PagePair> pairs)
    {
        Begin("table", "pair");
        foreach (var pair in pairs)
        {
            _xml.WriteStartElement("tr");
            Element("th", pair.Name);
            Begin("td", pair.Style);
            if (pair.Key is { } key) _xml.WriteAttributeString("data-name", key);
            if (pair.Value is { } value) _xml.WriteAttributeString("data-value", value.ToString("R", CultureInfo.InvariantCulture));
            _xml.WriteString(MarkupText.Allowed(pair.Text));
            End();
            End();
        }

        End();
    }

    /// <param name="rows">Rows with as many cells as headings.</param>
    public void Table(IReadOnlyList<string> headings, IEnumerable<IReadOnlyList<string>> rows)
    {
        _xml.WriteStartElement("table");
        _xml.WriteStartElement("thead");
        _xml.WriteStartElement("tr");
        foreach (var heading in headings) Element("th", heading);
        End();
        End();
        _xml.WriteStartElement("tbody");
        foreach (var row in rows)
        {
            _xml.WriteStartElement("tr");
            for (var column = 0; column < row.Count; column++) Element("td", row[column], column == 0 ? "mark" : "");
            End();
        }

        End();
        End();
    }

    public void Dispose() => _xml.Dispose();

    private static string Style()
    {
        using var style = new StreamReader(typeof(PageWriter).Assembly.GetManifestResourceStream("page.css")!);
        return style.ReadToEnd().ReplaceLineEndings("\n");
    }

    private void Meta(params ReadOnlySpan<(string Name, string Value)> attributes)
    {
        _xml.WriteStartElement("meta");
        foreach (var (name, value) in attributes) _xml.WriteAttributeString(name, value);
        _xml.WriteEndElement();
    }

    private void Element(string name, string text, string style = "")
    {
        Begin(name, style);
        _xml.WriteString(MarkupText.Allowed(text));
        End();
    }

    private void Begin(string name, string style)
    {
        _xml.WriteStartElement(name);
        if (style.Length > 0) _xml.WriteAttributeString("class", style);
    }

    /// <summary>Always writes an end tag, as required by HTML.</summary>
    private void End()
    {
        _xml.WriteFullEndElement();
        _xml.WriteString("\n");
    }
}

/// <summary>A name and its value.</summary>
/// <param name="Key">Name in the JSON of the console; null if it is not machine-readable.</param>
/// <param name="Value">The exact number; null for text.</param>
internal sealed record PagePair(string Name, string Text, string? Key = null, double? Value = null, string Style = "")
{
    /// <summary>A number with its unit.</summary>
    public static PagePair Of(string name, string key, double? value, string form) =>
        new(name, value is { } known ? known.ToString(form, CultureInfo.InvariantCulture) : "–", key, value, "number");
}
